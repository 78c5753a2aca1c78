// SPDX-License-Identifier: Apache-2.0
#include "actuator/ChestKick.h"

#include "actuator/Gait.h"

namespace kelpie::actuator {
namespace {

// 0..1, standing still at both ends.
double smooth(double phase) {
  const double p = maths::clamp(phase, 0.0, 1.0);
  return p * p * (3.0 - 2.0 * p);
}

double part(std::uint32_t tick, std::uint32_t start, std::uint32_t length) {
  if (tick <= start) return 0.0;
  return static_cast<double>(tick - start) / static_cast<double>(length);
}

}  // namespace

std::uint32_t chestKickTicks(const KickParams& kick) {
  return kick.leanTicks + kick.pushTicks + kick.holdTicks + kick.returnTicks;
}

double chestKickLean(std::uint32_t tick, const KickParams& kick) {
  const std::uint32_t push = kick.leanTicks;
  const std::uint32_t back = push + kick.pushTicks + kick.holdTicks;
  const double leaning = -kick.leanBack * smooth(part(tick, 0, kick.leanTicks));
  // The push starts from rest and is cut off at full speed: the servos' lag rounds it.
  const double thrown = maths::clamp(part(tick, push, kick.pushTicks), 0.0, 1.0);
  const double pushed = (kick.leanBack + kick.pushAhead) * thrown * thrown;
  const double returned = -kick.pushAhead * smooth(part(tick, back, kick.returnTicks));
  return leaning + pushed + returned;
}

void stepChestKick(std::uint32_t tick, const ActuatorParams& params, GaitState& state) {
  const double before = chestKickLean(tick, params.kick);
  const double after = chestKickLean(tick + 1, params.kick);
  // While it leans back the feet also slide to their homes, so that the push starts symmetrical.
  const double slide =
      1.0 / (1.0 + params.kick.leanTicks - maths::clamp<double>(tick, 0.0, params.kick.leanTicks));
  for (std::size_t leg = 0; leg < kLegCount; ++leg) {
    Point3<Robot>& foot = state.feet[leg].position;
    const Point3<Robot> home = footHome(static_cast<LegId>(leg), params.stance);
    const double off = foot.y + before - home.y;
    const bool sliding = tick < params.kick.leanTicks;
    foot.x += sliding ? slide * (home.x - foot.x) : 0.0;
    foot.y = home.y - after + (sliding ? (1.0 - slide) * off : off);
    foot.z = 0.0;
  }
  state.velocity = {(after - before) / kTickSeconds, 0.0, 0.0};
}

}  // namespace kelpie::actuator
