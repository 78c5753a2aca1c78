// SPDX-License-Identifier: Apache-2.0
// What tools may ask the behaviours.
#include <gtest/gtest.h>

#include "tests/behaviour/Scripts.h"

namespace kelpie::behaviour {
namespace {

Expected<Rows> asked(const std::string& functions) {
  const Scripts scripts;
  scripts.write("main.py", "def decide(world):\n    return None\n\n" + functions);
  BehaviourState state(scripts.path());
  return state.ask("tree");
}

TEST(Ask, RowsAndSingleTextsComeAsTexts) {
  const auto rows = asked("def tree():\n    return [('a', 1, True), 'b', ['c', 0.5]]\n");
  ASSERT_TRUE(rows) << rows.error();
  EXPECT_EQ(*rows, (Rows{{"a", "1", "True"}, {"b"}, {"c", "0.5"}}));
}

TEST(Ask, WhatIsNotThereOrFailsIsOneLine) {
  EXPECT_EQ(asked("").error(), "AttributeError: main.py has no tree()");
  const std::string error = asked("def tree():\n    return 1 / 0\n").error();
  EXPECT_NE(error.find("main.py:5: ZeroDivisionError: division by zero"), std::string::npos);
  EXPECT_NE(asked("def tree():\n    return 7\n").error().find("TypeError"), std::string::npos);
  EXPECT_NE(asked("boom(").error().find("SyntaxError"), std::string::npos);
}

TEST(Ask, AnEndlessAnswerIsEnded) {
  EXPECT_NE(asked("def tree():\n    while True:\n        pass\n").error().find("TimeLimit"),
            std::string::npos);
}

TEST(Ask, DecidingGoesOnAfterAFailure) {
  const Scripts scripts("return kelpie.Command(walk=kelpie.WalkRequest(forward=3.0))");
  HostRun run(scripts);
  EXPECT_FALSE(run.state.ask("tree"));
  EXPECT_EQ(run.step().walk.forward, 3.0);
}

}  // namespace
}  // namespace kelpie::behaviour
