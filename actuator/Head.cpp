// SPDX-License-Identifier: Apache-2.0
#include "actuator/Head.h"

#include <cmath>

#include "robot/core/Time.h"

namespace kelpie::actuator {
namespace {

constexpr double kLowNeck = -40.0;       // deg; below it the nod is limited (openr.md 5.6)
constexpr double kNodAtLowNeck = 5.0;    // deg, least nod with the neck down
constexpr double kNodAtHighNeck = -5.0;  // deg, least nod with the neck up
constexpr double kNear = 1e-6;           // deg

Angle towards(Angle now, Angle wish, double most) {
  const double step = (wish - now).rad();
  if (!std::isfinite(step) || std::fabs(step) <= most) return std::isfinite(step) ? wish : now;
  return Angle::rad(now.rad() + (step > 0 ? most : -most));
}

}  // namespace

JointAngles headWish(const HeadRequest& request, const JointAngles& now,
                     const ActuatorParams& params) {
  const bool limited = std::isfinite(request.speed) && request.speed > 0.0;
  const double most = limited ? std::fmin(request.speed * kTickSeconds, params.headSlew.rad())
                              : params.headSlew.rad();
  JointAngles wish = now;
  // The neck waits at its bound until the head is up far enough to pass the chest.
  const bool headDown = now[Joint::headNod].deg() < kNodAtLowNeck - kNear;
  const bool waits = headDown && request.neckTilt.deg() < kLowNeck;
  const Angle neck = waits ? Angle::deg(kLowNeck) : request.neckTilt;
  wish[Joint::neckTilt] = towards(now[Joint::neckTilt], neck, most);
  wish[Joint::headPan] = towards(now[Joint::headPan], request.headPan, most);
  const bool low = waits || wish[Joint::neckTilt].deg() < kLowNeck;
  const double least = low ? kNodAtLowNeck : kNodAtHighNeck;
  const Angle nod = request.headNod.deg() < least ? Angle::deg(least) : request.headNod;
  wish[Joint::headNod] = towards(now[Joint::headNod], nod, most);
  return wish;
}

}  // namespace kelpie::actuator
