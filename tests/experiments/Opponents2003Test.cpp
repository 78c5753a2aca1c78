// SPDX-License-Identifier: Apache-2.0
// The failure that made thesis 2004 section 2.3 choose one filter for a sighting.
#include <gtest/gtest.h>

#include <algorithm>

#include "gps/players/Information.h"
#include "gps/players/Opponents.h"
#include "robot/body/Camera.h"
#include "tools/experiments/baselines/Opponents2003.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

// The largest distance of two of the four, after one robot has been in sight for 100 s.
double spread(bool of2003) {
  const GpsParams params;
  const body::FieldDescription field = *body::fieldDescription("2006");
  const PlayersContext context{field, params.players, params.ball};
  PoseMode pose;
  pose.weight = 1.0;
  pose.pose = {{180, 100}, Angle::deg(90)};
  pose.covariance = {9, 0, 0, 0, 9, 0, 0, 0, 1e-3};
  FrameInput input;
  input.elapsed = 1.0 / 30.0;
  Percepts percepts;
  RobotPercept robot;
  robot.team = TeamColour::blue;
  robot.distance = 180.0;
  robot.heading = Angle::deg(10);
  robot.distanceVariance = 700.0;
  robot.headingVariance = 1e-3;
  percepts.robots.push_back(robot);
  Opponents opponents;
  GpsCounts counts;
  for (int frame = 0; frame < 3000; ++frame) {
    if (of2003) {
      stepOpponents2003({input, percepts, body::step(input, {}).camera}, pose, context, opponents);
    } else {
      stepOpponents({input, percepts, body::step(input, {}).camera}, pose, context, opponents,
                    counts);
    }
  }
  double max = 0.0;
  for (const OpponentFilter& a : opponents.filters)
    for (const OpponentFilter& b : opponents.filters)
      max = std::max(max, (placeOf(a.belief).mean - placeOf(b.belief).mean).norm());
  return max;
}

TEST(Opponents2003, AllFourComeTogetherOnTheOneInSight) { EXPECT_LT(spread(true), 35.0); }

TEST(Opponents2003, WithOneFilterForASightingTheOthersStayApart) {
  EXPECT_GT(spread(false), 100.0);
}

}  // namespace
}  // namespace kelpie::gps
