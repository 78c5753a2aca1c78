// SPDX-License-Identifier: Apache-2.0
// What a script says of why it asks for what it asks.
#include <gtest/gtest.h>

#include "tests/behaviour/Scripts.h"

namespace kelpie::behaviour {
namespace {

struct Traced {
  Command command;
  std::string error;
};

Traced reported(const std::string& trace) {
  const Scripts scripts("return kelpie.Command(trace=" + trace + ")");
  HostRun run(scripts);
  Traced result;
  result.command = run.step();
  result.error = run.state.lastError();
  return result;
}

TEST(Trace, IsReadInOrderFromTuples) {
  const Traced result = reported(
      "[(kelpie.LAYER_PLAYER, 'forward', 'play', 'the game is on'),"
      " (kelpie.LAYER_SKILL, 'grab_dribble', 'aim', 'gap {} deg, {} cm', 12.5, 80)]");
  ASSERT_EQ(result.command.trace.size(), 2U) << result.error;
  const TraceStep& first = result.command.trace[0];
  EXPECT_EQ(first.layer, TraceLayer::player);
  EXPECT_EQ(first.module.view(), "forward");
  EXPECT_EQ(first.branch.view(), "play");
  EXPECT_EQ(first.reason.view(), "the game is on");
  EXPECT_TRUE(first.numbers.empty());
  const TraceStep& second = result.command.trace[1];
  EXPECT_EQ(second.layer, TraceLayer::skill);
  ASSERT_EQ(second.numbers.size(), 2U);
  EXPECT_EQ(second.numbers[0], 12.5);
  EXPECT_EQ(second.numbers[1], 80.0);
}

TEST(Trace, OfACommandThatSaysNothingIsEmpty) {
  const Scripts scripts("return kelpie.Command()");
  HostRun run(scripts);
  EXPECT_TRUE(run.step().trace.empty());
  EXPECT_EQ(run.state.lastError(), "");
}

TEST(Trace, BeyondNineStepsAndThreeNumbersIsCutOff) {
  const Traced result = reported("[(0, 'm', 'b', 'r', 1, 2, 3, 4, None)] * 10 + [None]");
  ASSERT_EQ(result.command.trace.size(), 9U) << result.error;
  EXPECT_EQ(result.command.trace[8].numbers.size(), 3U);
}

TEST(Trace, LongTextsAreCutOffAtACharacter) {
  const Traced result = reported("[(0, 'm' * 50, 'b' * 50, 'r' * 79 + chr(0xe9) + 'x')]");
  ASSERT_EQ(result.command.trace.size(), 1U) << result.error;
  EXPECT_EQ(result.command.trace[0].module.view(), std::string(20, 'm'));
  EXPECT_EQ(result.command.trace[0].branch.view(), std::string(24, 'b'));
  EXPECT_EQ(result.command.trace[0].reason.view(), std::string(79, 'r'));
}

TEST(Trace, LayersAndNumbersOutOfRangeAreClamped) {
  const Traced result = reported("[(9, 'm', 'b', 'r', math.inf, -1e9), (-10**30, 'm', 'b', 'r')]");
  ASSERT_EQ(result.command.trace.size(), 2U) << result.error;
  EXPECT_EQ(result.command.trace[0].layer, TraceLayer::skill);
  EXPECT_EQ(result.command.trace[0].numbers[0], 1e6);
  EXPECT_EQ(result.command.trace[0].numbers[1], -1e6);
  EXPECT_EQ(result.command.trace[1].layer, TraceLayer::player);
}

TEST(Trace, OfWrongTypesIsABadCommandWithOneClearLine) {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"None", "Command.trace is a NoneType, not a list"},
      {"'why'", "Command.trace is a str, not a list"},
      {"['why']", "Command.trace[0] is a str, not a tuple (layer, module, branch, reason, "},
      {"[(0, 'm', 'b')]", "Command.trace[0] is too short, not a tuple (layer, "},
      {"[('0', 'm', 'b', 'r')]", "Command.trace[0].layer is a str, not a whole number"},
      {"[(0, 5, 'b', 'r')]", "Command.trace[0].module is a int, not a text"},
      {"[(0, 'm', None, 'r')]", "Command.trace[0].branch is a NoneType, not a text"},
      {"[(0, 'm', 'b', 'r'), (0, 'm', 'b', b'r')]", "[1].reason is a bytes, not a text"},
      {"[(0, 'm', 'b', chr(0xd800))]", "Command.trace[0].reason is a str, not a text"},
      {"[(0, 'm', 'b', 'r', 1, 'x')]", "Command.trace[0].numbers[1] is a str, not a number"},
      {"[(0, 'm', 'b', 'r', math.nan)]", "Command.trace[0].numbers[0] is not a number"},
      {"[(0, 'm', 'b', 'r', 10**400)]", "Command.trace[0].numbers[0] is not a number"}};
  for (const auto& [trace, line] : wrong) {
    const Traced result = reported(trace);
    EXPECT_EQ(result.command.fallback, Fallback::badCommand) << trace;
    EXPECT_NE(result.error.find(line), std::string::npos) << trace << ": " << result.error;
    EXPECT_EQ(result.error.find('\n'), std::string::npos) << trace;
  }
}

TEST(Trace, OfARefusedCommandIsNotReported) {
  const Scripts scripts("return kelpie.Command(motion='kick', trace=[(0, 'm', 'b', 'r')])");
  HostRun run(scripts);
  const Command command = run.step();
  EXPECT_EQ(command.fallback, Fallback::badCommand);
  EXPECT_TRUE(command.trace.empty());
}

TEST(Trace, OfTheLastCommandIsShownInTheView) {
  const Scripts scripts(
      "trace = world.last_command.trace; return kelpie.Command(walk=kelpie.WalkRequest("
      "forward=len(trace[0].reason) if trace else 0))");
  HostRun run(scripts);
  EXPECT_EQ(run.step().walk.forward, 0.0);
  run.input.lastCommand.trace.resize(1);
  run.input.lastCommand.trace[0].reason.assign("why");
  EXPECT_EQ(run.step().walk.forward, 3.0) << run.state.lastError();
}

}  // namespace
}  // namespace kelpie::behaviour
