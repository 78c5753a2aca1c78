// SPDX-License-Identifier: Apache-2.0
// Scripts that want too much memory, or stay where no interrupt reaches them.
#include <gtest/gtest.h>

#include <algorithm>

#include "behaviour/watch/HungExit.h"
#include "tests/behaviour/Scripts.h"

namespace kelpie::behaviour {
namespace {

constexpr const char* kTooMuch = "MemoryError: it takes more memory than it is given";

// A main.py that keeps something between the frames.
void keep(const Scripts& scripts, const std::string& body) {
  scripts.write("main.py", "import kelpie\nkept = []\n\ndef decide(world):\n    global kept\n    " +
                               body + "\n    return kelpie.Command()\n");
}

class Greedy : public testing::TestWithParam<const char*> {};

TEST_P(Greedy, ScriptGetsAMemoryErrorAtItsLine) {
  const Scripts scripts(GetParam());
  HostRun run(scripts);
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_EQ(run.step().fallback, Fallback::scriptError);
    const std::string where = scripts.path() + "/main.py:5: " + kTooMuch;
    EXPECT_EQ(run.state.lastError(), where) << GetParam();
  }
  EXPECT_EQ(run.state.reports().number, 1U) << "told once";
}

INSTANTIATE_TEST_SUITE_P(
    Limits, Greedy,
    testing::Values("return [0] * 10 ** 9", "return len('a' * 10 ** 9)",
                    "return list(range(10 ** 9))",
                    "x = []; [x.append('word' * 1000) for i in range(10 ** 6)]",
                    "x = ' '.join(map(str, range(10 ** 8)))",
                    "x = {i: i for i in range(10 ** 7)}"));

TEST(Limits, NextFramePlaysAfterAMemoryError) {
  const Scripts scripts("x = [0] * (10 ** 9 if world.frame == 1 else 1)\n    " +
                        std::string("return kelpie.Command(walk=kelpie.WalkRequest(forward=5))"));
  HostRun run(scripts);
  EXPECT_EQ(run.step().fallback, Fallback::scriptError);
  EXPECT_EQ(run.step().walk.forward, 5.0);
}

// Chains of small objects leave no memory at all, but for the error itself.
TEST(Limits, SmallObjectsAreCountedTooAndTheErrorStillHasItsPlace) {
  const Scripts scripts("x = []\n    while True: x = [x]");
  HostRun run(scripts);
  EXPECT_EQ(run.step().fallback, Fallback::scriptError);
  EXPECT_EQ(run.state.lastError(), scripts.path() + "/main.py:6: " + kTooMuch);
}

// The modules and functions of a version hold one another, so that only a collection frees it. Ten
// edits of the shipped behaviours took all the memory that a script is given.
TEST(Limits, EditsLeaveNothingOfTheVersionsBefore) {
  const Scripts scripts;
  scripts.write("big.py", "kept = [0] * 250000\n");  // 2 MB of 12
  const std::string decide =
      "import big; more = [0] * 250000\n    return kelpie.Command(walk=kelpie.WalkRequest(forward=";
  HostRun run(scripts);
  for (int edit = 1; edit <= 20; ++edit) {
    scripts.writeDecide(decide + std::to_string(edit) + "))");
    ASSERT_EQ(run.step().walk.forward, edit) << run.state.lastError();
    scripts.write("main.py", "import big\nmore = [0] * 250000\nraise ValueError\n");
    ASSERT_EQ(run.step().walk.forward, edit) << "a version that does not load is no edit";
  }
}

TEST(Limits, ScriptThatCatchesItsMemoryErrorsForEverIsCutOff) {
  const Scripts scripts;
  keep(scripts, "while True:\n        try: kept.append('x' * 1000)\n        except: pass");
  HostRun run(scripts);
  EXPECT_EQ(run.step().fallback, Fallback::timeLimit);
  EXPECT_EQ(run.step().fallback, Fallback::timeLimit);
}

// What fills the room lives as long as its version; the edit gets room of its own.
TEST(Limits, EditLoadsWhereTheVersionBeforeHasFilledItsRoom) {
  const Scripts scripts;
  keep(scripts, "while True: kept.append('x' * 1000)");
  HostRun run(scripts);
  EXPECT_EQ(run.step().fallback, Fallback::scriptError);
  scripts.writeDecide("return kelpie.Command(walk=kelpie.WalkRequest(forward=5))");
  EXPECT_EQ(run.step().walk.forward, 5.0) << run.state.lastError();
}

TEST(Limits, RoomIsAsLargeAsTheParameterSays) {
  const Scripts scripts("return kelpie.Command(motion=len([0] * 1500000) - 1499998)");
  HostRun run(scripts);
  EXPECT_EQ(run.step().fallback, Fallback::scriptError) << "11.4 MB of 12, of which 2 are taken";
  run.params.heapLimit = 20.0;
  EXPECT_EQ(run.step().fallback, Fallback::none) << run.state.lastError();
}

TEST(Limits, ScriptThatLoadsTooMuchFallsBack) {
  const Scripts scripts;
  scripts.write("main.py", "kept = [0] * 10 ** 9\n");
  HostRun run(scripts);
  EXPECT_EQ(run.step().fallback, Fallback::notLoaded);
  EXPECT_EQ(run.state.lastError(), scripts.path() + "/main.py:1: " + kTooMuch);
}

// Python looks for signals in the arithmetic of large numbers.
TEST(Limits, LargeNumbersAreCutOffLikeALoop) {
  const Scripts scripts("return 7 ** 10 ** 7");
  HostRun run(scripts);
  EXPECT_EQ(run.step().fallback, Fallback::timeLimit);
}

using LimitsDeathTest = testing::Test;

TEST(LimitsDeathTest, OneLongCallEndsTheProcessWithItsPlaceAndText) {
  const Scripts scripts("n = 10 ** 10\n    return sum(range(n))");
  const auto play = [&] { HostRun(scripts).step(); };
  EXPECT_EXIT(play(), testing::ExitedWithCode(kHungExit),
              "^behaviour: [^\n]*/main.py:6: it does not end and cannot be broken off, so that "
              "this process ends: return sum\\(range\\(n\\)\\)\n$");
}

TEST(LimitsDeathTest, ScriptThatLoadsForEverEndsTheProcessWithAnotherCode) {
  const Scripts scripts;
  scripts.write("main.py", "x = max(range(10 ** 10))\n");
  const auto play = [&] { HostRun(scripts).step(); };
  EXPECT_EXIT(play(), testing::ExitedWithCode(kHungLoadExit), "/main.py:1: it does not end");
}

}  // namespace
}  // namespace kelpie::behaviour
