// SPDX-License-Identifier: Apache-2.0
// The constants of the behaviours: from the parameters of a robot to the modules of its scripts.
#include <gtest/gtest.h>

#include "tests/behaviour/Scripts.h"

namespace kelpie::behaviour {
namespace {

constexpr const char* kScript =
    "import kelpie\n"
    "CARRY_TO = kelpie.constants.dribble.carry_to\n"
    "FRAMES = kelpie.constants.dribble.over_turn\n"
    "def decide(world):\n"
    "    whole = 1.0 if type(FRAMES) is int else 0.0\n"
    "    return kelpie.Command(walk=kelpie.WalkRequest(forward=CARRY_TO / 10.0,\n"
    "                                                  left=FRAMES * whole))\n";

TEST(Constants, AModuleHasTheDefaultsWhenItIsLoaded) {
  const Scripts scripts;
  scripts.write("main.py", kScript);
  HostRun run(scripts);
  const Command command = run.step();
  EXPECT_EQ(command.walk.forward, 6.5);
  EXPECT_EQ(command.walk.left, 8.0);
}

TEST(Constants, EachRobotOfAProcessHasItsOwn) {
  const Scripts scripts;
  scripts.write("main.py", kScript);
  HostRun first(scripts);
  Constants others;
  others.dribble.carryTo = 80.0;
  others.dribble.overTurn = 5;
  HostRun second(scripts, others, first);
  EXPECT_EQ(second.step().walk.forward, 8.0);
  EXPECT_EQ(second.step().walk.left, 5.0);
  EXPECT_EQ(first.step().walk.forward, 6.5);
}

TEST(Constants, AnEditIsLoadedWithTheSame) {
  const Scripts scripts;
  scripts.write("main.py", kScript);
  HostRun first(scripts);
  Constants others;
  others.dribble.carryTo = 80.0;
  HostRun second(scripts, others, first);
  second.params.reloadFrames = 1;
  second.step();
  scripts.write("main.py", std::string(kScript) + "\n# edited\n");
  EXPECT_EQ(second.step().walk.forward, 8.0);
}

}  // namespace
}  // namespace kelpie::behaviour
