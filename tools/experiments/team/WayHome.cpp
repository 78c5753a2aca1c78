// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/team/WayHome.h"

#include "tools/sim/rules/MatchScene.h"

namespace kelpie::experiments {
namespace {

constexpr double kAtHome = 30.0;  // cm, where the walk home ends
// cm between the lines of two bodies: as the referee has it, stripes of 14 cm and what a head
// reaches beyond its own (tools/sim/rules/Pushing.cpp).
constexpr double kTouching = 2.0 * sim::kStripeHalfWidth + 3.0;
constexpr double kApart = 0.5;  // s

bool touchesBlue(const sim::TruthFrame& truth, const Pose2& pose) {
  for (const sim::RobotTruth& robot : truth.robots)
    if (robot.team == TeamColour::blue && sim::stripeDistance(pose, robot.pose) < kTouching)
      return true;
  return false;
}

}  // namespace

WayHome wayHomeOf(const Played& played, std::uint8_t player) {
  WayHome way;
  std::optional<double> touched;  // when it last did
  for (const PlayedMoment& moment : played.moments) {
    const TeamNote& note = moment.command.team;
    const Pose2* pose = redPose(moment.truth, player);
    if (pose == nullptr || !moment.seen) continue;
    const bool defends = note.role == Role::defender && note.wants;
    if (defends && distance(pose->position, note.wanted) < kAtHome) {
      way.home = moment.seconds();
      break;
    }
    if (!touchesBlue(moment.truth, *pose)) continue;
    way.contacts += touched && moment.seconds() - *touched < kApart ? 0 : 1;
    touched = moment.seconds();
  }
  return way;
}

}  // namespace kelpie::experiments
