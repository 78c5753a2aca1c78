// SPDX-License-Identifier: Apache-2.0
// How well eight robots that push each other know where they are, and what their teams know of the
// ball: a match of four against four by the rules, from pixels. Only frames in which a robot plays
// count.
#include <cmath>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/team/TeamMatch.h"

namespace kelpie::experiments {
namespace {

constexpr double kSeconds = 600.0;
constexpr double kLost = 50.0;  // cm

struct Found {
  Values pose, heading;      // cm, deg
  Values ownBall, teamBall;  // cm
};

void judgeFrame(const TeamRobot& robot, const TeamFrame& frame, const sim::TruthFrame& truth,
                Found& found) {
  static const body::FieldDescription field;
  const Point2<Field> ball = sim::ownView(field, robot.team, truth.ball);
  for (const sim::RobotTruth& one : truth.robots) {
    if (!robot.is(one)) continue;
    const Point2<Field> place = sim::ownView(field, robot.team, one.pose.position);
    const Angle heading = one.pose.heading + Angle::deg(robot.team == TeamColour::red ? 0 : 180);
    found.pose.push_back(distance(frame.pose.position, place));
    found.heading.push_back(std::fabs((frame.pose.heading - heading).deg()));
  }
  if (frame.ball) found.ownBall.push_back(distance(frame.ballAt, ball));
  if (frame.teamBall) found.teamBall.push_back(distance(frame.teamBallAt, ball));
}

Expected<Json> teamLocalise(const Request& request) {
  Found found;
  const auto judge = [&](const cli::SessionResult&, const TeamMatch& match) {
    for (const TeamRobot& robot : match.robots)
      for (const TeamFrame& frame : robot.frames)
        if (frame.plays()) judgeFrame(robot, frame, match.at(frame.seconds), found);
  };
  const Status played = playFours(request, {kSeconds}, judge);
  if (!played) return Error{played.error()};
  return Json{{"pose_error_mean_cm", mean(found.pose)},
              {"pose_error_p95_cm", percentile(found.pose, 0.95)},
              {"heading_error_mean_deg", mean(found.heading)},
              {"lost_share", shareAbove(found.pose, kLost)},
              {"own_ball_error_mean_cm", mean(found.ownBall)},
              {"own_ball_error_median_cm", percentile(found.ownBall, 0.5)},
              {"team_ball_error_mean_cm", mean(found.teamBall)},
              {"team_ball_error_median_cm", percentile(found.teamBall, 0.5)}};
}

const Registration kTeamLocalise(
    "team-localise", "eight robots that push each other: errors of pose and of the team's ball",
    {Option::trials, Option::seed, Option::randomised, Option::params, Option::fast}, 1,
    teamLocalise);

}  // namespace
}  // namespace kelpie::experiments
