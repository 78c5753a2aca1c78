// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>

#include "tests/behaviour/Scripts.h"

namespace kelpie::behaviour {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Host, ScriptsCommandReachesTheBody) {
  const Scripts scripts(
      "return kelpie.Command(walk=kelpie.WalkRequest(forward=12.0, turn_deg=90), motion=3)");
  HostRun run(scripts);
  const Command command = run.step();
  EXPECT_EQ(command.fallback, Fallback::none) << run.state.lastError();
  EXPECT_EQ(command.walk.forward, 12.0);
  EXPECT_NEAR(command.walk.turn, 1.5707963, 1e-6);
  EXPECT_EQ(command.motion, MotionKind::kickForward);
}

TEST(Host, DriversCommandGoesAheadOfTheScripts) {
  const Scripts scripts("return kelpie.Command(walk=kelpie.WalkRequest(forward=12.0))");
  HostRun run(scripts);
  run.input.drive.present = true;
  run.input.drive.command.walk.forward = -7.0;
  EXPECT_EQ(run.step().walk.forward, -7.0);
  run.input.drive.present = false;
  EXPECT_EQ(run.step().walk.forward, 12.0);
}

TEST(Host, DriversCommandOutOfRangeMakesTheRobotStand) {
  const Scripts scripts("return kelpie.Command()");
  HostRun run(scripts);
  run.input.drive.present = true;
  for (const double speed : {1000.0, std::nan("")}) {
    run.input.drive.command.walk.forward = speed;
    const Command command = run.step();
    EXPECT_EQ(command.fallback, Fallback::badCommand);
    EXPECT_EQ(command.walk.forward, 0.0);
  }
}

TEST(Host, SyntaxErrorNamesFileAndLineAndFallsBack) {
  const Scripts scripts;
  scripts.write("main.py", "import kelpie\n\ndef decide(world)\n    return 1\n");
  HostRun run(scripts);
  EXPECT_EQ(run.step().fallback, Fallback::notLoaded);
  EXPECT_TRUE(contains(run.state.lastError(), "main.py:3:")) << run.state.lastError();
}

TEST(Host, MissingFolderFallsBack) {
  BehaviourState state("/nonexistent/pycode");
  const FrameInput input;
  const Command command = step(BehaviourIn{input, {}, {}, {}}, {}, state);
  EXPECT_EQ(command.fallback, Fallback::notLoaded);
  EXPECT_NE(state.lastError(), "");
}

TEST(Host, RaisedErrorNamesTheLineAndIsRetried) {
  const Scripts scripts("return kelpie.Command() if world.frame > 1 else world.nothing");
  HostRun run(scripts);
  EXPECT_EQ(run.step().fallback, Fallback::scriptError);
  EXPECT_TRUE(contains(run.state.lastError(), "main.py:5: AttributeError"));
  EXPECT_EQ(run.step().fallback, Fallback::none);
  EXPECT_EQ(run.state.lastError(), "");
}

TEST(Host, SameErrorIsPrintedOnce) {
  const Scripts scripts("raise ValueError('sour')");
  HostRun run(scripts);
  testing::internal::CaptureStderr();
  for (int i = 0; i < 5; ++i) run.step();
  const std::string printed = testing::internal::GetCapturedStderr();
  EXPECT_EQ(printed.find("sour"), printed.rfind("sour"));
  EXPECT_TRUE(contains(printed, "sour"));
}

TEST(Host, SystemExitIsAScriptError) {
  const Scripts scripts("raise SystemExit(3)");
  HostRun run(scripts);
  EXPECT_EQ(run.step().fallback, Fallback::scriptError);
}

// The robot's stack has room for 80 calls (toolchain/openr/calls.txt); so deep goes a PC, no
// deeper.
TEST(Host, CallsDeeperThanTheRobotsStackAreAScriptErrorOnThePcToo) {
  const std::string deep =
      "f = lambda n: n and f(n - 1)\n    f(world.frame)\n    return kelpie.Command()";
  const Scripts scripts(deep);
  HostRun run(scripts);
  run.input.frame = 74;
  EXPECT_EQ(run.step().fallback, Fallback::none);
  run.input.frame = 84;
  EXPECT_EQ(run.step().fallback, Fallback::scriptError);
}

TEST(Host, EndlessRecursionIsAScriptErrorOfAFewLines) {
  const Scripts scripts("return decide(world)");
  HostRun run(scripts);
  testing::internal::CaptureStderr();
  EXPECT_EQ(run.step().fallback, Fallback::scriptError);
  const std::string reported = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(reported.begin(), reported.end(), '\n'), 10) << reported;
  EXPECT_TRUE(contains(reported, "main.py:5: RecursionError")) << reported;
}

TEST(Host, EndlessLoopIsCutOffAndTheEditedFileWorks) {
  const Scripts scripts("while True: pass");
  HostRun run(scripts);
  const std::clock_t start = std::clock();
  EXPECT_EQ(run.step().fallback, Fallback::timeLimit);
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 0.5);
  EXPECT_TRUE(contains(run.state.lastError(), "main.py:5: TimeLimit")) << run.state.lastError();
  scripts.writeDecide("return kelpie.Command(walk=kelpie.WalkRequest(forward=5))");
  EXPECT_EQ(run.step().walk.forward, 5.0);
}

TEST(Host, EndlessLoopThatCatchesEverythingIsCutOffToo) {
  const Scripts scripts(
      "while True:\n        try:\n            x = 1\n        except:\n            pass");
  HostRun run(scripts);
  EXPECT_EQ(run.step().fallback, Fallback::timeLimit);
  EXPECT_EQ(run.step().fallback, Fallback::timeLimit);
}

TEST(Host, EndlessLoopIsCalledEverMoreSeldom) {
  const Scripts scripts;
  scripts.write("main.py",
                "calls = 0\n\n\ndef decide(world):\n    global calls\n    calls += 1\n"
                "    while True: pass\n\n\ndef count():\n    return [str(calls)]\n");
  HostRun run(scripts);
  run.params.timeLimit = 0.02;
  for (int frame = 0; frame < 20; ++frame) EXPECT_EQ(run.step().fallback, Fallback::timeLimit);
  EXPECT_EQ(run.state.ask("count")->front().front(), "6") << "frames 0, 1, 2, 5, 10, 19";
}

TEST(Host, EndlessLoopWhileLoadingIsCutOff) {
  const Scripts scripts;
  scripts.write("main.py", "while True:\n    pass\n");
  HostRun run(scripts);
  EXPECT_EQ(run.step().fallback, Fallback::notLoaded);
}

TEST(Host, FallbackStandsAndTurnsTheHead) {
  const Scripts scripts("raise ValueError()");
  HostRun run(scripts);
  double min = 0.0, max = 0.0;
  for (int i = 0; i < 120; ++i) {
    const Command command = run.step();
    EXPECT_EQ(command.walk.forward, 0.0);
    min = std::min(min, command.head.headPan.deg());
    max = std::max(max, command.head.headPan.deg());
  }
  EXPECT_NEAR(min, -60.0, 1.0);
  EXPECT_NEAR(max, 60.0, 1.0);
}

TEST(Host, EditReplacesEverything) {
  const Scripts scripts;
  scripts.write("main.py",
                "import kelpie\nfrom skills import go\n\ndef decide(world):\n"
                "    return kelpie.Command(walk=kelpie.WalkRequest(forward=go.SPEED))\n");
  scripts.write("skills/go.py", "SPEED = 3\n");
  HostRun run(scripts);
  EXPECT_EQ(run.step().walk.forward, 3.0) << run.state.lastError();
  scripts.write("skills/go.py", "SPEED = 17\n");
  EXPECT_EQ(run.step().walk.forward, 17.0);
}

TEST(Host, BrokenEditKeepsTheOldRunningAndReports) {
  const Scripts scripts("return kelpie.Command(walk=kelpie.WalkRequest(forward=7))");
  HostRun run(scripts);
  run.step();
  scripts.write("main.py", "import kelpie\nboom(\n");
  const Command command = run.step();
  EXPECT_EQ(command.walk.forward, 7.0);
  EXPECT_TRUE(contains(run.state.lastError(), "main.py:2:")) << run.state.lastError();
}

// What a step prints.
std::string heard(HostRun& run) {
  testing::internal::CaptureStderr();
  run.step();
  return testing::internal::GetCapturedStderr();
}

constexpr const char* kSeven = "return kelpie.Command(walk=kelpie.WalkRequest(forward=7))";

TEST(Host, FirstLoadingIsSilent) {
  testing::internal::CaptureStderr();
  const Scripts scripts(kSeven);
  HostRun run(scripts);
  run.step();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Host, EditIsReportedByItsNameWhenItTakesEffect) {
  const Scripts scripts(kSeven);
  scripts.write("skills/go.py", "SPEED = 3\n");
  HostRun run(scripts);
  run.step();
  scripts.write("skills/go.py", "SPEED = 17\n");
  EXPECT_EQ(heard(run), "behaviour: skills/go.py: loaded again\n");
  EXPECT_EQ(heard(run), "");
}

TEST(Host, SyntaxErrorInAnEditIsOneLineOnceAndTheMendedFilePlays) {
  const Scripts scripts(kSeven);
  HostRun run(scripts);
  run.step();
  scripts.write("main.py", "import kelpie\nboom(\n");
  const std::string reported = heard(run);
  EXPECT_TRUE(contains(reported, scripts.path() + "/main.py:2: SyntaxError: ")) << reported;
  EXPECT_TRUE(contains(reported, "; the version before plays on\n")) << reported;
  EXPECT_EQ(std::count(reported.begin(), reported.end(), '\n'), 1) << reported;
  for (int i = 0; i < 3; ++i) EXPECT_EQ(heard(run), "");
  EXPECT_TRUE(contains(run.state.lastError(), "main.py:2:"));
  scripts.writeDecide("return kelpie.Command(walk=kelpie.WalkRequest(forward=5))");
  EXPECT_EQ(heard(run), "behaviour: main.py: loaded again\n");
  EXPECT_EQ(run.step().walk.forward, 5.0);
  EXPECT_EQ(run.state.lastError(), "");
}

TEST(Host, DeletedFileIsReportedOnceAndTheOldVersionPlaysOnUntilItIsBack) {
  const Scripts scripts(kSeven);
  HostRun run(scripts);
  run.step();
  for (int time = 0; time < 2; ++time) {  // it is reported again when it goes again
    scripts.remove("main.py");
    EXPECT_EQ(heard(run), "behaviour: main.py: gone; the version before plays on\n");
    EXPECT_EQ(heard(run), "");
    EXPECT_EQ(run.step().walk.forward, 7.0);
    EXPECT_EQ(run.state.lastError(), "main.py: gone");
    scripts.writeDecide(kSeven);
    EXPECT_EQ(heard(run), "behaviour: main.py: loaded again\n");
    EXPECT_EQ(run.state.lastError(), "");
  }
}

TEST(Host, DeletedModuleIsReportedByItsNameOneThatNobodyNeedsByTheWay) {
  const Scripts scripts("from skills.go import SPEED\n    " + std::string(kSeven));
  scripts.write("main.py",
                "import kelpie\nfrom skills.go import SPEED\n\ndef decide(world):\n    " +
                    std::string(kSeven) + "\n");
  scripts.write("skills/go.py", "SPEED = 3\n");
  scripts.write("skills/spare.py", "");
  HostRun run(scripts);
  run.step();
  scripts.remove("skills/spare.py");
  EXPECT_EQ(heard(run), "behaviour: skills/spare.py: gone; the rest: loaded again\n");
  scripts.remove("skills/go.py");
  EXPECT_EQ(heard(run), "behaviour: skills/go.py: gone; the version before plays on\n");
  EXPECT_EQ(run.step().walk.forward, 7.0);
}

TEST(Host, WholeFolderGoneIsOneLine) {
  const Scripts scripts(kSeven);
  for (const char* name : {"a.py", "b.py", "c.py"}) scripts.write(name, "");
  HostRun run(scripts);
  run.step();
  std::filesystem::remove_all(scripts.path());
  EXPECT_EQ(heard(run),
            "behaviour: a.py, b.py, c.py and 1 more: gone; the version before plays on\n");
  EXPECT_EQ(run.step().walk.forward, 7.0);
  scripts.writeDecide(kSeven);
  EXPECT_TRUE(contains(heard(run), "main.py: loaded again\n"));
}

TEST(Host, FileThatCannotBeReadIsReportedByItsName) {
  const Scripts scripts(kSeven);
  HostRun run(scripts);
  run.step();
  scripts.remove("main.py");
  std::filesystem::create_directory(scripts.path() + "/main.py");  // unreadable, for root too
  const std::string reported = heard(run);
  EXPECT_TRUE(contains(reported, scripts.path() + "/main.py")) << reported;
  EXPECT_TRUE(contains(reported, "; the version before plays on\n")) << reported;
  EXPECT_EQ(std::count(reported.begin(), reported.end(), '\n'), 1) << reported;
  EXPECT_EQ(run.step().walk.forward, 7.0);
}

TEST(Host, ChangedPermissionsAreLookedAt) {
  const Scripts scripts(kSeven);
  HostRun run(scripts);
  run.step();
  std::filesystem::permissions(scripts.path() + "/main.py", std::filesystem::perms::none);
  EXPECT_TRUE(contains(heard(run), "main.py"));  // root reads it all the same, others cannot
  EXPECT_EQ(run.step().walk.forward, 7.0);
}

TEST(Host, EditorsLocksAreNoEdits) {
  const Scripts scripts(kSeven);
  HostRun run(scripts);
  run.step();
  std::filesystem::create_symlink("user@host", scripts.path() + "/.#main.py");
  EXPECT_EQ(heard(run), "");
}

TEST(Host, MainWithoutDecideIsNamed) {
  const Scripts scripts;
  scripts.write("main.py", "import kelpie\n");
  HostRun run(scripts);
  EXPECT_TRUE(contains(run.state.lastError(), "main.py has no decide(world)"));
}

TEST(Host, ReloadCanBeSwitchedOff) {
  const Scripts scripts("return kelpie.Command(walk=kelpie.WalkRequest(forward=7))");
  HostRun run(scripts);
  run.params.reload = false;
  run.step();
  scripts.writeDecide("return kelpie.Command()");
  EXPECT_EQ(run.step().walk.forward, 7.0);
}

class Forbidden : public testing::TestWithParam<const char*> {};

TEST_P(Forbidden, CannotBeReachedByAScript) {
  const Scripts scripts(std::string(GetParam()) + "; return kelpie.Command()");
  HostRun run(scripts);
  EXPECT_EQ(run.step().fallback, Fallback::scriptError) << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Host, Forbidden,
                         testing::Values("import os", "import time", "import socket",
                                         "import random", "import sys", "open('/etc/passwd')",
                                         "eval('1')", "__import__('posix')", "import main.os",
                                         "from math import os"));

TEST(Host, ZipOfBehavioursWorks) {
  const Scripts scripts(
      "from skills.go import SPEED\n"
      "    return kelpie.Command(walk=kelpie.WalkRequest(forward=SPEED))");
  scripts.write("skills/go.py", "SPEED = 3\n");
  const Scripts other;
  const std::string zip = other.path() + "/pycode.zip";
  const std::string make =
      "cd " + scripts.path() + " && /usr/bin/python3 -m zipfile -c " + zip + " main.py skills";
  ASSERT_EQ(std::system(make.c_str()), 0);
  BehaviourState state(zip);
  const FrameInput input;
  EXPECT_EQ(step(BehaviourIn{input, {}, {}, {}}, {}, state).walk.forward, 3.0) << state.lastError();
}

TEST(Host, TheShippedBehavioursDecide) {
  BehaviourState state(KELPIE_SOURCE_DIR "/pycode");
  const FrameInput input;
  EXPECT_EQ(step(BehaviourIn{input, {}, {}, {}}, {}, state).fallback, Fallback::none)
      << state.lastError();
}

TEST(Host, EmptyDecideCostsLessThanTwentyMicroseconds) {
  const Scripts scripts("return kelpie.Command()");
  HostRun run(scripts);
  run.params.reload = false;
  run.step();
  const std::clock_t start = std::clock();
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(run.step().fallback, Fallback::none);
  const double each = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / 2000;
  RecordProperty("microseconds", std::to_string(each * 1e6));
  std::printf("empty decide: %.2f us\n", each * 1e6);
  EXPECT_LT(each, 20e-6 * (getenv("ASAN_OPTIONS") != nullptr ? 10 : 1));
}

TEST(Host, TwoStatesOfOneProcessShareNoModule) {
  const Scripts counts;
  counts.write("here.py", "class Number:\n    value = 0.0\n");
  counts.write("main.py",
               "import kelpie\nfrom here import Number\n\ndef decide(world):\n"
               "    Number.value += 1.0\n"
               "    return kelpie.Command(walk=kelpie.WalkRequest(forward=Number.value))\n");
  HostRun one(counts);
  HostRun two(counts, one);
  for (int i = 0; i < 3; ++i) one.step();
  EXPECT_EQ(one.step().walk.forward, 4.0);
  EXPECT_EQ(two.step().walk.forward, 1.0);
}

TEST(Host, AStateBesideAnotherPlaysWhatTheFileSaysWhenItIsMade) {
  const Scripts scripts("return kelpie.Command(walk=kelpie.WalkRequest(forward=1.0))");
  HostRun one(scripts);
  scripts.writeDecide("return kelpie.Command(walk=kelpie.WalkRequest(forward=12.0))");
  HostRun two(scripts, one);
  EXPECT_EQ(two.step().walk.forward, 12.0);
  EXPECT_EQ(one.step().walk.forward, 12.0);
}

TEST(Host, AScriptWithoutEndIsBrokenOffBesideAnotherThatPlaysOn) {
  const Scripts endless("while True: pass");
  const Scripts good("return kelpie.Command()");
  HostRun one(good);
  HostRun two(endless, one);
  two.params.timeLimit = 0.02;
  EXPECT_EQ(two.step().fallback, Fallback::timeLimit);
  EXPECT_EQ(one.step().fallback, Fallback::none);
}

TEST(Host, WhoeverPlaysOnKeepsTheInterpreterOfOneThatHasEnded) {
  const Scripts good("return kelpie.Command()");
  auto one = std::make_unique<HostRun>(good);
  HostRun two(good, *one);
  one.reset();
  EXPECT_EQ(two.step().fallback, Fallback::none);
}

}  // namespace
}  // namespace kelpie::behaviour
