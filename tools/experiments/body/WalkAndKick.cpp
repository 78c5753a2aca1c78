// SPDX-License-Identifier: Apache-2.0
// The actuator in the simulated body, without pixels: how far the robot really walks for what its
// odometry says, and how far and straight the ball goes from each place in the kick's zone.
#include <cmath>

#include "tools/experiments/body/Paths.h"
#include "tools/experiments/harness/Experiment.h"

namespace kelpie::experiments {
namespace {

constexpr int kWalkMessages = 90;
constexpr int kStopMessages = 30;

// Until the actuator spares the legs, and they stand still.
void wearOut(sim::WalkingBody& body) {
  constexpr int kMessages = 200;
  body.wearOut();
  for (int i = 0; i < kMessages; ++i) body.step({});
}

// True way over the way that the odometry reports.
Displacement walkRatio(const WalkRequest& request, std::uint64_t seed, bool weak = false) {
  sim::WalkingBody body(seed);
  if (weak) wearOut(body);
  Paths ways;
  walkOn(body, request, kWalkMessages, ways);
  walkOn(body, {}, kStopMessages, ways);
  const auto& [walked, reported] = ways;
  return {walked.forward / reported.forward, walked.left / reported.left,
          walked.turn / reported.turn};
}

// From where the ball lay to where it stops, in the robot frame at the kick.
Point2<Robot> kicked(Point2<Robot> from, std::uint64_t seed) {
  sim::WalkingBody body(seed);
  const Pose2 pose = body.pose();
  body.world().putBall({fieldFromRobot(pose, from), {0.0, 0.0}});
  Command command;
  command.motion = MotionKind::kickForward;
  for (int i = 0; i < 150; ++i) body.step(i < 20 ? command : Command{});
  return robotFromField(pose, body.world().ball().position) - from;
}

Expected<Json> walkAndKick(const Request& request) {
  double shortest = 1e9;
  double sum = 0.0;
  double largest = 0.0;
  int kicks = 0;
  const double place = actuator::standardMotions()[MotionKind::kickForward].kick.ahead;
  for (const double ahead : {-1.0, -0.5, 0.0, 0.5, 1.0})
    for (const double x : {-0.8, -0.4, 0.0, 0.4, 0.8}) {
      const auto seed = request.seed + static_cast<std::uint64_t>(kicks);
      const Point2<Robot> way = kicked({x, place + ahead}, seed);
      shortest = std::fmin(shortest, way.y);
      sum += way.y;
      largest = std::fmax(largest, std::fabs(bearing(way).deg()));
      ++kicks;
    }
  return Json{{"forward_ratio", walkRatio({20.0, 0.0, 0.0}, request.seed).forward},
              {"back_ratio", walkRatio({-15.0, 0.0, 0.0}, request.seed).forward},
              {"side_ratio", walkRatio({0.0, 12.0, 0.0}, request.seed).left},
              {"turn_ratio", walkRatio({0.0, 0.0, 1.2}, request.seed).turn},
              {"weak_forward_ratio", walkRatio({20.0, 0.0, 0.0}, request.seed, true).forward},
              {"weak_side_ratio", walkRatio({0.0, 12.0, 0.0}, request.seed, true).left},
              {"weak_turn_ratio", walkRatio({0.0, 0.0, 1.2}, request.seed, true).turn},
              {"kicks", kicks},
              {"kick_mean_cm", sum / kicks},
              {"kick_min_cm", shortest},
              {"kick_bearing_deg", largest}};
}

const Registration kWalkAndKick("walk-and-kick",
                                "walked way over odometry's; how far and straight the ball goes",
                                {Option::seed}, 1, walkAndKick);

}  // namespace
}  // namespace kelpie::experiments
