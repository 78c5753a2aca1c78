// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "robot/core/FieldCheck.h"
#include "tools/sim/Sensors.h"

namespace kelpie::sim {
namespace {

struct Place {
  std::vector<Obstacle> obstacles = obstaclesOf(*body::fieldDescription("2006"));
  std::vector<RobotModel> robots;
  Ball ball{{180, 300}, {}};

  Place() { robots.emplace_back(RobotParams{}, Pose2{{180, 200}, Angle::deg(90)}, 1); }
  Surroundings around() const { return {ball, obstacles, robots, 0}; }
};

TEST(Sensors, RayStopsAtGroundBallAndGoal) {
  Place place;
  // 10 cm high, falling 1 in 2: the ground is 10 sqrt(5) away.
  const double c = 1.0 / std::sqrt(5.0);
  EXPECT_NEAR(rayDistance(place.around(), {100, 100, 10}, {2 * c, 0, -c}), 10.0 * std::sqrt(5.0),
              1e-9);
  EXPECT_NEAR(rayDistance(place.around(), {180, 250, 4.2}, {0, 1, 0}), 50.0 - 4.2, 1e-9);
  // The blue goal's back wall is at 570 and 0.6 cm thick to each side.
  EXPECT_NEAR(rayDistance(place.around(), {180, 500, 15}, {0, 1, 0}), 69.4, 0.6);
}

TEST(Sensors, StandingStillUpReadsGravity) {
  Place place;
  SensorParams params;
  params.accelerationSd = 0.0;
  Random random(1);
  const SensorFrame frame = sense(place.around(), params, random);
  const double tilt = place.robots[0].place().stance.bodyTilt.rad();
  EXPECT_NEAR(frame.acceleration[2], 981.0 * std::cos(tilt), 1e-6);
  EXPECT_NEAR(frame.acceleration[0], -981.0 * std::sin(tilt), 1e-6);
  EXPECT_TRUE(frame.paw[0] && frame.paw[1] && frame.paw[2] && frame.paw[3]);
  EXPECT_FALSE(frame.chin);
}

TEST(Sensors, FrameIsInsideItsRanges) {
  Place place;
  Random random(1);
  std::string why;
  for (int i = 0; i < 50; ++i) {
    place.robots[0].tick();
    EXPECT_TRUE(verify(sense(place.around(), {}, random), &why)) << why;
  }
}

}  // namespace
}  // namespace kelpie::sim
