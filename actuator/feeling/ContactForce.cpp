// SPDX-License-Identifier: Apache-2.0
#include "actuator/feeling/ContactForce.h"

#include <cmath>

#include "robot/body/Ers7.h"
#include "robot/core/Maths.h"
#include "robot/core/Time.h"

namespace kelpie::actuator {
namespace {

constexpr double kNudge = 1e-3;  // rad, of the differences that tell how a foot moves
constexpr double kFlat = 60.0;   // cm3: three ways of a foot whose volume is less are one plane

using Vector = Point3<Torso>;

double finiteOr(double value, double otherwise) { return std::isfinite(value) ? value : otherwise; }

Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Vector scaled(const Vector& a, double s) { return {s * a.x, s * a.y, s * a.z}; }

Vector sum(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

body::LegTurns turnsAt(LegId leg, const double* angle, double more) {
  return body::turnsOf(
      leg, {Angle::rad(angle[0] + more), Angle::rad(angle[1] + more), Angle::rad(angle[2] + more)});
}

// Where the foot goes for a radian of a joint whose nudged turns these are.
Vector wayOf(LegId leg, const body::LegTurns& nudged, const Vector& foot) {
  return scaled(sum(body::footPosition(leg, nudged), scaled(foot, -1.0)), 1.0 / kNudge);
}

// Where the foot goes for a radian of each joint. Angles and nudged angles each have their sines
// once: three times as many took a tenth of the motion step.
std::array<Vector, 3> directionsOf(LegId leg, const body::LegTurns& here,
                                   const body::LegTurns& nudged, const Vector& foot) {
  return {wayOf(leg, {nudged.rotator, here.shoulder, here.knee}, foot),
          wayOf(leg, {here.rotator, nudged.shoulder, here.knee}, foot),
          wayOf(leg, {here.rotator, here.shoulder, nudged.knee}, foot)};
}

// The force whose work along each joint's way is that joint's torque.
Vector forceOf(const std::array<Vector, 3>& way, const double* torque) {
  const std::array<Vector, 3> across{cross(way[1], way[2]), cross(way[2], way[0]),
                                     cross(way[0], way[1])};
  const double volume = dot(way[0], across[0]);
  const Vector all = sum(sum(scaled(across[0], torque[0]), scaled(across[1], torque[1])),
                         scaled(across[2], torque[2]));
  return scaled(all, volume / (volume * volume + kFlat * kFlat));
}

}  // namespace

SensedLegs sensedLegs(const SensorFrame& tick, const SensedLegs& before) {
  SensedLegs now;
  for (std::size_t j = 0; j < kJointsOfLegs; ++j) {
    const std::size_t joint = kFirstLegJoint + j;
    const double angle = finiteOr(tick.joints.angle[joint].rad(), before.angle[j]);
    now.angle[j] = maths::clamp(angle, -maths::kPi, maths::kPi);
    now.duty[j] = maths::clamp(finiteOr(tick.duty[joint], before.duty[j]), -1.0, 1.0);
  }
  return now;
}

LegCurrents legCurrents(const SensedLegs& last, const SensedLegs& middle, const SensedLegs& next,
                        double noLoad) {
  LegCurrents currents{};
  for (std::size_t j = 0; j < kJointsOfLegs; ++j) {
    const double speed = (next.angle[j] - last.angle[j]) / (2.0 * kTickSeconds);
    currents[j] = maths::clamp(middle.duty[j] - speed / noLoad, -1.0, 1.0);
  }
  return currents;
}

double rotatorCurrent(const LegCurrents& currents) {
  double sum = 0.0;
  for (std::size_t leg = 0; leg < kLegCount; ++leg) sum += std::fabs(currents[3 * leg]);
  return sum / kLegCount;
}

ContactForce contactForceOf(const LegCurrents& currents, const SensedLegs& legs) {
  ContactForce push;
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const auto leg = static_cast<LegId>(i);
    const double* angle = &legs.angle[3 * i];
    const body::LegTurns here = turnsAt(leg, angle, 0.0);
    const Vector foot = body::footPosition(leg, here);
    const Vector force =
        forceOf(directionsOf(leg, here, turnsAt(leg, angle, kNudge), foot), &currents[3 * i]);
    push.forward += force.y;
    push.left -= force.x;
    push.turn += foot.x * force.y - (foot.y + 0.5 * body::kBodyLength) * force.x;
  }
  return push;
}

}  // namespace kelpie::actuator
