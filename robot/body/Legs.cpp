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

// Foot in the leg's plane, before shoulder and rotator turn it: the geometry of facts-2005
// section 2.4 (knee, then upper leg, then shoulder, then rotator).
struct PlaneFoot {
  double x;
  double y;
};
PlaneFoot planeFoot(double knee, double along, double ahead = 0.0) {
  const maths::SinCos k = maths::sinCos(knee);
  return {kKneeForward + along * k.sin + ahead * k.cos, kUpperLeg + along * k.cos - ahead * k.sin};
}

// A point of the lower leg in its plane, turned as shoulder and rotator turn it.
Point3<Torso> ofLowerLeg(LegId leg, const LegAngles& angles, const PlaneFoot& plane) {
  const maths::SinCos out = maths::sinCos(angles.shoulder.rad());
  const double down = plane.y * out.cos - kKneeOut * out.sin;
  const double outwards = plane.y * out.sin + kKneeOut * out.cos;
  const maths::SinCos turn = maths::sinCos(mirrorOf(leg) * angles.rotator.rad());
  return inTorso(
      leg, {plane.x * turn.cos + down * turn.sin, down * turn.cos - plane.x * turn.sin, outwards});
}

// What can touch the ground, in the sagittal plane of the torso, raised by kPawRadius, which every
// edge is round by: paws, cowls, chest and belly.
struct Contact {
  double y;
  double z;
};
constexpr std::size_t kFrontContacts = 5;
constexpr std::size_t kContactCount = kFrontContacts + 3;
using Contacts = std::array<Contact, kContactCount>;

Contacts contacts(const JointAngles& joints) {
  const auto support = [&](std::size_t i) {
    const Support s = supportOf(i, joints);
    return Contact{s.middle.y, s.middle.z - (s.radius - kPawRadius)};
  };
  constexpr double kEdge = kPawRadius - kChestDepth;
  return {{{0.0, kEdge},
           support(index(LegId::leftFront)),
           support(index(LegId::rightFront)),
           support(kLegCount),
           support(kLegCount + 1),
           {-kBodyLength, kEdge},
           support(index(LegId::leftHind)),
           support(index(LegId::rightHind))}};
}

// How far the lowest contact is below the line through a hind and a front one; 0 = none is.
double deepestBelow(const Contacts& all, const Contact& hind, const Contact& front) {
  const double slope = (front.z - hind.z) / (front.y - hind.y);
  double deepest = 0.0;
  for (const Contact& c : all) deepest = std::fmax(deepest, hind.z + slope * (c.y - hind.y) - c.z);
  return deepest;
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
  return ofLowerLeg(leg, angles, planeFoot(angles.knee.rad(), lowerLength(leg)));
}

LegId legOfSupport(std::size_t i) {
  if (i < kLegCount) return static_cast<LegId>(i);
  return i == kLegCount ? LegId::leftFront : LegId::rightFront;
}

Support supportOf(std::size_t i, const JointAngles& joints) {
  const LegId leg = legOfSupport(i);
  const LegAngles angles = legAngles(joints, leg);
  const double knee = angles.knee.rad();
  const bool paw = i < kLegCount;
  const PlaneFoot plane = paw ? planeFoot(knee, lowerLength(leg) - kPawRadius)
                              : planeFoot(knee, kCowlEnds, -kCowlBehind);
  return {ofLowerLeg(leg, angles, plane), paw ? kPawRadius : kCowlRadius};
}

LegSolution reachFoot(LegId leg, Point3<Torso> foot) {
  const Reach wanted = fromTorso(leg, foot);
  const double length = lowerLength(leg);
  const double upper = maths::hypot(kUpperLeg, kKneeForward);
  const double inPlane = maths::square(wanted.x) + maths::square(wanted.y) +
                         maths::square(wanted.z) - maths::square(kKneeOut);
  const double bend = (inPlane - upper * upper - length * length) / (2.0 * upper * length);
  const double knee = maths::atan2(kKneeForward, kUpperLeg) + maths::acos(bend);
  const PlaneFoot plane = planeFoot(knee, length);
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
  constexpr double kShortestBase = 1.0;  // cm; contacts nearer than that carry no body
  const Contacts all = contacts(joints);
  Contact front = all[0];
  Contact hind = all[kFrontContacts];
  double best = deepestBelow(all, hind, front);
  for (std::size_t f = 0; f < kFrontContacts; ++f) {
    for (std::size_t h = kFrontContacts; h < kContactCount; ++h) {
      if (all[f].y - all[h].y < kShortestBase) continue;
      const double below = deepestBelow(all, all[h], all[f]);
      if (below >= best) continue;
      best = below;
      front = all[f];
      hind = all[h];
    }
  }
  const Angle tilt = Angle::rad(maths::atan2(front.z - hind.z, front.y - hind.y));
  return {kPawRadius + front.y * tilt.sin() - front.z * tilt.cos(), tilt, {}};
}

Point3<Robot> robotFromTorso(const Stance& stance, const Point3<Torso>& p) {
  const maths::SinCos lean = maths::sinCos(stance.bodyTilt.rad());
  const double y = p.y + kNeckBehindShoulder;
  const double z = p.z - kNeckAboveShoulder;
  const double up = p.z * lean.cos - p.y * lean.sin;
  return {p.x, y * lean.cos + z * lean.sin, stance.shoulderHeight + up};
}

Point3<Torso> torsoFromRobot(const Stance& stance, const Point3<Robot>& p) {
  const maths::SinCos lean = maths::sinCos(stance.bodyTilt.rad());
  const double forward = p.y - kNeckBehindShoulder * lean.cos + kNeckAboveShoulder * lean.sin;
  const double up = p.z - stance.shoulderHeight;
  return {p.x, forward * lean.cos - up * lean.sin, forward * lean.sin + up * lean.cos};
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
