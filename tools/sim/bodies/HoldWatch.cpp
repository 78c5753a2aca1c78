// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/bodies/HoldWatch.h"

#include <cmath>
#include <utility>

namespace kelpie::sim {
namespace {

void goOn(double seconds, const Pose2& robot, Hold& hold) {
  hold.end = seconds;
  hold.moved = std::fmax(hold.moved, distance(robot.position, hold.start.position));
  hold.turned = std::fmax(hold.turned, std::fabs((robot.heading - hold.start.heading).rad()));
}

}  // namespace

bool inHold(const Pose2& robot, Point2<Field> ball) {
  const Point2<Robot> place = robotFromField(robot, ball);
  return place.y > kHeldNearest && place.y < kHeldFurthest && std::fabs(place.x) < kHeldLateral;
}

void HoldWatch::see(double seconds, const Pose2& robot, Point2<Field> ball) {
  std::optional<Hold>& hold = now_ ? now_ : begun_;
  if (inHold(robot, ball)) {
    if (!hold) hold = Hold{seconds, seconds, 0.0, 0.0, robot};
    goOn(seconds, robot, *hold);
    if (!now_ && begun_->seconds() >= kSettles) now_ = std::exchange(begun_, std::nullopt);
  } else if (hold && seconds - hold->end >= kLost) {
    if (now_) ended_.push_back(*now_);
    hold.reset();
  }
}

void HoldWatch::finish() {
  if (now_) ended_.push_back(*now_);
  now_.reset();
  begun_.reset();
}

}  // namespace kelpie::sim
