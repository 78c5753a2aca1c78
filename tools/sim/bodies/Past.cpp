// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/bodies/Past.h"

#include <algorithm>
#include <cmath>

namespace kelpie::sim {
namespace {

constexpr double kJump = 10.0;  // cm in a tick that no ball rolls: the referee moved it

double mixed(double a, double b, double t) { return a + t * (b - a); }
Angle mixed(Angle a, Angle b, double t) { return a + (b - a) * t; }
Point2<Field> mixed(Point2<Field> a, Point2<Field> b, double t) { return a + (b - a) * t; }

BodyPlace mixed(const BodyPlace& a, const BodyPlace& b, double t) {
  BodyPlace place;
  place.pose = {mixed(a.pose.position, b.pose.position, t),
                mixed(a.pose.heading, b.pose.heading, t)};
  place.stance = {mixed(a.stance.shoulderHeight, b.stance.shoulderHeight, t),
                  mixed(a.stance.bodyTilt, b.stance.bodyTilt, t),
                  mixed(a.stance.bodyRoll, b.stance.bodyRoll, t)};
  for (std::size_t j = 0; j < kJointCount; ++j) {
    place.joints.angle[j] = mixed(a.joints.angle[j], b.joints.angle[j], t);
  }
  place.lean = a.lean;
  return place;
}

}  // namespace

void Past::remember(std::uint32_t tick, const Bodies& bodies) {
  last_ = tick;
  Moment& moment = moments_[tick % kTicks];
  moment.ball = bodies.ball();
  moment.robots.clear();
  for (std::size_t i = 0; i < bodies.count(); ++i) moment.robots.push_back(bodies.place(i));
}

void Past::carry(std::size_t robot, const Pose2& pose) {
  for (Moment& moment : moments_)
    if (robot < moment.robots.size()) moment.robots[robot].pose = pose;
}

const Past::Moment& Past::at(std::int64_t tick) const {
  const std::int64_t oldest = std::max<std::int64_t>(0, last_ - static_cast<int>(kTicks) + 1);
  return moments_[static_cast<std::size_t>(std::min(std::max(tick, oldest), last_)) % kTicks];
}

BodyPlace Past::place(std::size_t robot, double ticks) const {
  const double whole = std::floor(ticks);
  const auto tick = static_cast<std::int64_t>(whole);
  return mixed(at(tick).robots[robot], at(tick + 1).robots[robot], ticks - whole);
}

Point2<Field> Past::ball(double ticks) const {
  const double whole = std::floor(ticks);
  const auto tick = static_cast<std::int64_t>(whole);
  const Ball& before = at(tick).ball;
  const Ball& after = at(tick + 1).ball;
  const bool moved = distance(before.position, after.position) > kJump;
  return moved ? before.position : mixed(before.position, after.position, ticks - whole);
}

}  // namespace kelpie::sim
