// SPDX-License-Identifier: Apache-2.0
// Whatever reaches the localiser, what it believes stays finite, and good sightings afterwards
// bring the pose back.
#include <gtest/gtest.h>

#include "robot/core/fields/FieldCheck.h"
#include "tests/core/SpoiltValue.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

// A frame of random percepts, odometry and messages, every list of random length, spoilt here and
// there; joints, images and games are left out.
void attack(sim::LocalisingRobot& robot, Random& random) {
  const std::uint32_t rarity = 1U << random.index(9);
  randomise(robot.percepts, random);
  spoil(robot.percepts, random, rarity);
  FrameInput& in = robot.input;
  randomise(in.odometry, random);
  randomise(in.headRate, random);
  randomise(in.motion, random);
  randomise(in.team, random);
  randomise(in.sensors.joints, random);
  in.elapsed = random.chance(0.5) ? 1.0 / 30 : random.uniform(0.0, 10.0);
  spoil(in.elapsed, random, 3);
  spoil(in.odometry, random, rarity);
  spoil(in.headRate, random, rarity);
  spoil(in.motion, random, rarity);
  spoil(in.team, random, rarity);
  spoil(in.sensors.joints, random, rarity);
  spoil(in.stance, random, rarity);
}

class HostileInput : public testing::TestWithParam<int> {};

TEST_P(HostileInput, LeavesAFiniteBeliefAndGoodSightingsBringThePoseBack) {
  const auto seed = static_cast<std::uint64_t>(GetParam());
  Random random(seed);
  sim::LocalisingRobot robot({180, 200, 1.0}, seed);
  robot.params.lines.update.use = static_cast<LineUse>(seed % 3);
  if (seed / 3 % 2 == 0) robot.params.modes.wideWeight = 0.0;
  const FrameInput calm = robot.input;
  for (int i = 0; i < 40; ++i) {
    attack(robot, random);
    const WorldModel world = robot.step();
    std::string why;
    ASSERT_TRUE(verify(world, &why)) << "frame " << i << ": " << why;
  }
  robot.params = GpsParams{};
  robot.params.field = *body::fieldDescription("2006");
  robot.input = calm;
  robot.percepts = Percepts{};
  WorldModel world;
  for (int i = 0; i < 400; ++i) {
    robot.walk(0.0, 0.0, 0.0);
    robot.lookAround(sim::panAt(i));
    world = robot.step();
  }
  EXPECT_LT(robot.error(world), 15.0);
}
INSTANTIATE_TEST_SUITE_P(Seeds, HostileInput, testing::Range(1, 37));

}  // namespace
}  // namespace kelpie::gps
