// SPDX-License-Identifier: Apache-2.0
#include "actuator/walk/WalkSpeed.h"

#include <cmath>
#include <cstring>

namespace kelpie::actuator {
namespace {

// Each round shrinks the error by the share of one direction in another, at most a third.
constexpr int kRounds = 12;
constexpr int kHalvings = 12;  // of a request twenty times too fast to half a percent

double finite(double value) { return std::isfinite(value) ? value : 0.0; }

double along(const SpeedCurve& curve, double s) {
  return curve.scale * s + curve.bend * s * std::fabs(s);
}

// The smaller solution; where the curve never comes so far, its summit.
double against(const SpeedCurve& curve, double real) {
  if (curve.bend == 0.0) return real / curve.scale;
  const double root = curve.scale * curve.scale + 4.0 * curve.bend * std::fabs(real);
  const double size = root <= 0.0 ? -curve.scale / (2.0 * curve.bend)
                                  : 2.0 * std::fabs(real) / (curve.scale + std::sqrt(root));
  return real < 0.0 ? -size : size;
}

const SpeedCurve& forwardCurve(const WalkCalibration& c, double forward) {
  return forward < 0.0 ? c.back : c.forward;
}

// What each direction gives to the others.
Velocity acrossOf(const Velocity& feet, const WalkCalibration& c) {
  return {c.forwardPerTurn * std::fabs(feet.turn) + c.forwardPerLeft * std::fabs(feet.left) +
              c.forwardPerLeftTurn * feet.left * feet.turn,
          along(c.leftPerTurn, feet.turn) + c.leftPerForwardTurn * feet.forward * feet.turn,
          along(c.turnPerLeft, feet.left) + c.turnPerForwardLeft * feet.forward * feet.left};
}

double square(double value) { return value * value; }

Velocity times(double share, const Velocity& v) {
  return {share * v.forward, share * v.left, share * v.turn};
}

// 1 where the feet go as far as they may.
double strokeShare(const Velocity& feet, const StrokeLimits& max) {
  return std::sqrt(square(feet.forward / (feet.forward < 0.0 ? max.back : max.forward)) +
                   square(feet.left / max.left) + square(feet.turn / max.turn));
}

// The most that the feet do of a request that is beyond them. The request shrinks until they can,
// not their speeds: the calibration's curves end where the feet do, and asked for 20 rad/s they
// made a turn on the spot 11 deg/s faster and 6 cm/s astray.
Velocity maxTowards(const Velocity& real, const WalkSet& set) {
  double low = 0.0;
  double high = 1.0;
  for (int round = 0; round < kHalvings; ++round) {
    const double share = 0.5 * (low + high);
    const Velocity feet = feetSpeed(times(share, real), set.calibration);
    (strokeShare(feet, set.max) > 1.0 ? high : low) = share;
  }
  const Velocity feet = feetSpeed(times(high, real), set.calibration);
  return times(1.0 / std::fmax(1.0, strokeShare(feet, set.max)), feet);
}

double approach(double now, double target, double max) {
  return now + maths::clamp(target - now, -max, max);
}

}  // namespace

Velocity realSpeed(const Velocity& feet, const WalkCalibration& c) {
  const Velocity more = acrossOf(feet, c);
  return {along(forwardCurve(c, feet.forward), feet.forward) + more.forward,
          along(c.left, feet.left) + more.left, along(c.turn, feet.turn) + more.turn};
}

Velocity feetSpeed(const Velocity& real, const WalkCalibration& c) {
  Velocity feet;
  for (int round = 0; round < kRounds; ++round) {
    const Velocity more = acrossOf(feet, c);
    const Velocity last = feet;
    const double forward = real.forward - more.forward;
    feet = {against(forwardCurve(c, forward), forward), against(c.left, real.left - more.left),
            against(c.turn, real.turn - more.turn)};
    // The rounds left would give the same bits: straight on it is the second.
    if (std::memcmp(&feet, &last, sizeof feet) == 0) break;
  }
  return feet;
}

Velocity wantedSpeed(const WalkRequest& request, const WalkSet& set) {
  const double turn = finite(request.turn);
  const Velocity real{finite(request.forward), finite(request.left) - turn * finite(request.pivot),
                      turn};
  if (still(real)) return {};
  const Velocity feet = feetSpeed(real, set.calibration);
  return strokeShare(feet, set.max) > 1.0 ? maxTowards(real, set) : feet;
}

Velocity approached(const Velocity& now, const Velocity& wanted, const GaitParams& gait) {
  const double max = gait.acceleration * kTickSeconds;
  return {approach(now.forward, wanted.forward, max), approach(now.left, wanted.left, max),
          approach(now.turn, wanted.turn, gait.turnAcceleration * kTickSeconds)};
}

}  // namespace kelpie::actuator
