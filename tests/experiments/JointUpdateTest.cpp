// SPDX-License-Identifier: Apache-2.0
// Landmarks and lines in one update, with one copy.
#include <gtest/gtest.h>

#include "gps/pose/Modes.h"
#include "tools/experiments/baselines/JointUpdate.h"
#include "tools/experiments/baselines/PoseVariants.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

PoseMode someMode() {
  PoseMode mode;
  mode.weight = 0.7;
  mode.pose = {{150.0, 220.0}, Angle::deg(170.0)};
  mode.covariance = {120, 15, 0.4, 15, 80, -0.3, 0.4, -0.3, 0.05};
  return mode;
}

TEST(JointUpdate, AFrameSplitsEachModeOnce) {
  sim::LocalisingRobot robot({150.0, 220.0, 2.9}, 3);
  robot.params.modes.wideWeight = 0.0;
  robot.state.lines.features.build(robot.params.field);
  robot.state.pose.modes.push_back(someMode());
  const PaintedField field{robot.params.field, robot.state.lines.features};
  const JointParams params{robot.params.modes, robot.params.lines.update};
  Sightings both;
  both.landmarks.push_back({{0.0, 405.0}, true, true, 240.0, Angle::deg(-40.0), 400.0, 0.004});
  both.landmarks.push_back({{0.0, 135.0}, true, true, 172.0, Angle::deg(40.0), 400.0, 0.004});
  EXPECT_TRUE(updateJointly(both, field, params, robot.state.pose, robot.state.counts));
  EXPECT_EQ(robot.state.pose.modes.size(), 2U);
  EXPECT_FALSE(updateJointly({}, field, params, robot.state.pose, robot.state.counts));
}

}  // namespace
}  // namespace kelpie::gps
