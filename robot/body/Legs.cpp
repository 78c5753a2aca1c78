// SPDX-License-Identifier: Apache-2.0
#include "robot/body/Legs.h"

#include <cmath>

#include "robot/body/Ers7.h"

namespace kelpie::body {
namespace {

// A leg's own plane coordinates: x forward for front legs and backward for hind legs, which are
// mirror images of them; y down; z outwards. All from the shoulder axis.
struct Reach {
  double x;
  double y;
  double z;
};

bool isFront(LegId leg) { return leg == LegId::leftFront || leg == LegId::rightFront; }
double sideOf(LegId leg) {
  return leg == LegId::rightFront || leg == LegId::rightHind ? 1.0 : -1.0;
}
double mirrorOf(LegId leg) { return isFront(leg) ? 1.0 : -1.0; }
double lowerLength(LegId leg) { return isFront(leg) ? kLowerLegFront : kLowerLegHind; }
double axisForward(LegId leg) { return isFront(leg) ? 0.0 : -kBodyLength; }

Point3<Torso> inTorso(LegId leg, const Reach& r) {
  return {sideOf(leg) * (kBodyWidth / 2 + r.z), axisForward(leg) + mirrorOf(leg) * r.x, -r.y};
}

Reach fromTorso(LegId leg, const Point3<Torso>& p) {
  return {mirrorOf(leg) * (p.y - axisForward(leg)), -p.z, sideOf(leg) * p.x - kBodyWidth / 2};
}

// Foot in the leg's plane, before shoulder and rotator turn it: thesis-independent geometry of
// facts-2005 section 2.4 (knee, then upper leg, then shoulder, then rotator).
struct PlaneFoot {
  double x;
  double y;
};
PlaneFoot planeFoot(LegId leg, double knee) {
  const maths::SinCos k = maths::sinCos(knee);
  const double length = lowerLength(leg);
  return {kKneeForward + length * k.sin, kUpperLeg + length * k.cos};
}

double lowestFoot(const JointAngles& joints, LegId left, LegId right, const maths::SinCos& lean,
                  Point3<Torso>& foot) {
  const auto height = [&](const Point3<Torso>& p) { return p.z * lean.cos - p.y * lean.sin; };
  const Point3<Torso> a = footPosition(left, legAngles(joints, left));
  const Point3<Torso> b = footPosition(right, legAngles(joints, right));
  foot = height(a) < height(b) ? a : b;
  return height(foot);
}

}  // namespace

LegAngles legAngles(const JointAngles& joints, LegId leg) {
  const std::size_t first = firstJoint(leg);
  return {joints.angle[first], joints.angle[first + 1], joints.angle[first + 2]};
}

void setLegAngles(JointAngles& joints, LegId leg, const LegAngles& angles) {
  const std::size_t first = firstJoint(leg);
  joints.angle[first] = angles.rotator;
  joints.angle[first + 1] = angles.shoulder;
  joints.angle[first + 2] = angles.knee;
}

Point3<Torso> footPosition(LegId leg, const LegAngles& angles) {
  const PlaneFoot plane = planeFoot(leg, angles.knee.rad());
  const maths::SinCos out = maths::sinCos(angles.shoulder.rad());
  const double down = plane.y * out.cos - kKneeOut * out.sin;
  const double outwards = plane.y * out.sin + kKneeOut * out.cos;
  const maths::SinCos turn = maths::sinCos(mirrorOf(leg) * angles.rotator.rad());
  return inTorso(
      leg, {plane.x * turn.cos + down * turn.sin, down * turn.cos - plane.x * turn.sin, outwards});
}

LegSolution reachFoot(LegId leg, Point3<Torso> foot) {
  const Reach wanted = fromTorso(leg, foot);
  const double length = lowerLength(leg);
  const double upper = maths::hypot(kUpperLeg, kKneeForward);
  const double inPlane = maths::square(wanted.x) + maths::square(wanted.y) +
                         maths::square(wanted.z) - maths::square(kKneeOut);
  const double bend = (inPlane - upper * upper - length * length) / (2.0 * upper * length);
  const double knee = maths::atan2(kKneeForward, kUpperLeg) + maths::acos(bend);
  const PlaneFoot plane = planeFoot(leg, knee);
  const double reach = maths::hypot(plane.y, kKneeOut);
  const double lift = wanted.z / reach;
  const double shoulder = maths::asin(lift) - maths::atan2(kKneeOut, plane.y);
  const maths::SinCos out = maths::sinCos(shoulder);
  const double down = plane.y * out.cos - kKneeOut * out.sin;
  const double rotator = maths::atan2(wanted.x, wanted.y) - maths::atan2(plane.x, down);
  LegSolution solution;
  solution.angles = {Angle::rad(mirrorOf(leg) * rotator), Angle::rad(shoulder), Angle::rad(knee)};
  JointAngles joints;
  setLegAngles(joints, leg, solution.angles);
  setLegAngles(joints, leg, legAngles(withinLimits(joints), leg));
  const LegAngles limited = legAngles(joints, leg);
  solution.reached = std::fabs(bend) <= 1.0 && std::fabs(lift) <= 1.0 &&
                     limited.rotator == solution.angles.rotator &&
                     limited.shoulder == solution.angles.shoulder &&
                     limited.knee == solution.angles.knee;
  solution.angles = limited;
  return solution;
}

Stance stanceFromLegs(const JointAngles& joints) {
  Stance stance;
  // Which foot is lowest depends a little on the lean: the second round settles it.
  for (int round = 0; round < 2; ++round) {
    const maths::SinCos lean = maths::sinCos(stance.bodyTilt.rad());
    Point3<Torso> front;
    Point3<Torso> hind;
    lowestFoot(joints, LegId::leftFront, LegId::rightFront, lean, front);
    lowestFoot(joints, LegId::leftHind, LegId::rightHind, lean, hind);
    stance.bodyTilt = Angle::rad(maths::atan((front.z - hind.z) / (front.y - hind.y)));
    stance.shoulderHeight = front.y * stance.bodyTilt.sin() - front.z * stance.bodyTilt.cos();
  }
  return stance;
}

JointAngles withinLimits(const JointAngles& joints) {
  JointAngles limited = joints;
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const JointRange range = kJointRanges[j];
    limited.angle[j] = Angle::deg(maths::clamp(joints.angle[j].deg(), range.min, range.max));
    if (limited.angle[j].deg() == joints.angle[j].deg()) limited.angle[j] = joints.angle[j];
  }
  for (std::size_t leg = 0; leg < kLegCount; ++leg) {
    const std::size_t first = firstJoint(static_cast<LegId>(leg));
    const double lowest = lowestShoulder(static_cast<LegId>(leg), limited.angle[first].deg());
    if (limited.angle[first + 1].deg() < lowest) limited.angle[first + 1] = Angle::deg(lowest);
  }
  return limited;
}

}  // namespace kelpie::body
