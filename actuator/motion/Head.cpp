// SPDX-License-Identifier: Apache-2.0
#include "actuator/motion/Head.h"

#include <cmath>

#include "robot/core/Time.h"

namespace kelpie::actuator {
namespace {

constexpr double kLowNeck = -40.0;       // deg; below it the nod is limited (openr.md 5.6)
constexpr double kNodAtLowNeck = 5.0;    // deg, least nod with the neck down
constexpr double kNodAtHighNeck = -5.0;  // deg, least nod with the neck up
constexpr double kNear = 1e-6;           // deg

Angle towards(Angle now, Angle target, double maxStep) {
  const double step = (target - now).rad();
  if (!std::isfinite(step) || std::fabs(step) <= maxStep) return std::isfinite(step) ? target : now;
  return Angle::rad(now.rad() + (step > 0 ? maxStep : -maxStep));
}

}  // namespace

JointAngles headTarget(const HeadRequest& request, const JointAngles& now,
                       const ActuatorParams& params) {
  const bool limited = std::isfinite(request.speed) && request.speed > 0.0;
  const double maxStep = limited ? std::fmin(request.speed * kTickSeconds, params.headSlew.rad())
                                 : params.headSlew.rad();
  JointAngles target = now;
  // The neck waits at its bound until the head is up far enough to pass the chest.
  const bool headDown = now[Joint::headNod].deg() < kNodAtLowNeck - kNear;
  const bool waits = headDown && request.neckTilt.deg() < kLowNeck;
  const Angle neck = waits ? Angle::deg(kLowNeck) : request.neckTilt;
  target[Joint::neckTilt] = towards(now[Joint::neckTilt], neck, maxStep);
  target[Joint::headPan] = towards(now[Joint::headPan], request.headPan, maxStep);
  const bool low = waits || target[Joint::neckTilt].deg() < kLowNeck;
  const double minNod = low ? kNodAtLowNeck : kNodAtHighNeck;
  const Angle nod = request.headNod.deg() < minNod ? Angle::deg(minNod) : request.headNod;
  target[Joint::headNod] = towards(now[Joint::headNod], nod, maxStep);
  return target;
}

}  // namespace kelpie::actuator
