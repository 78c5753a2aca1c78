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
PlaneFoot planeFoot(const maths::SinCos& k, double along, double ahead = 0.0) {
  return {kKneeForward + along * k.sin + ahead * k.cos, kUpperLeg + along * k.cos - ahead * k.sin};
}

// A point of the lower leg in its plane, turned as shoulder and rotator turn it.
Point3<Torso> ofLowerLeg(LegId leg, const LegTurns& turns, const PlaneFoot& plane) {
  const maths::SinCos& out = turns.shoulder;
  const maths::SinCos& turn = turns.rotator;
  const double down = plane.y * out.cos - kKneeOut * out.sin;
  const double outwards = plane.y * out.sin + kKneeOut * out.cos;
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

Contacts contacts(const AllTurns& turns) {
  const auto support = [&](std::size_t i) {
    const Support s = supportOf(i, turns[index(legOfSupport(i))]);
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

constexpr double kUnlimited = 1e9;  // cm

// How far the lowest contact is below the line through a hind and a front one; 0 = none is. Any
// number from `enough` on where it is as much as that.
double deepestBelow(const Contacts& all, const Contact& hind, const Contact& front, double enough) {
  const double slope = (front.z - hind.z) / (front.y - hind.y);
  double deepest = 0.0;
  for (const Contact& c : all) {
    const double below = hind.z + slope * (c.y - hind.y) - c.z;
    if (below > deepest) deepest = below;
    if (deepest >= enough) break;
  }
  return deepest;
}

// A joint inside its range keeps its bits.
Angle withinRange(const JointRange& range, Angle angle) {
  const Angle limited = Angle::deg(maths::clamp(angle.deg(), range.min, range.max));
  return limited.deg() == angle.deg() ? angle : limited;
}

// The bounds of a leg's own joints.
LegAngles withinLimits(LegId leg, const LegAngles& angles) {
  const std::size_t first = firstJoint(leg);
  const auto bounded = [first](std::size_t j, Angle angle) {
    return withinRange(kJointRanges[first + j], angle);
  };
  LegAngles limited{bounded(0, angles.rotator), bounded(1, angles.shoulder),
                    bounded(2, angles.knee)};
  const double lowest = lowestShoulder(leg, limited.rotator.deg());
  if (limited.shoulder.deg() < lowest) limited.shoulder = Angle::deg(lowest);
  return limited;
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

LegTurns turnsOf(LegId leg, const LegAngles& angles) {
  return {maths::sinCos(mirrorOf(leg) * angles.rotator.rad()), maths::sinCos(angles.shoulder.rad()),
          maths::sinCos(angles.knee.rad())};
}

AllTurns turnsOf(const JointAngles& joints) {
  AllTurns turns;
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const auto leg = static_cast<LegId>(i);
    turns[i] = turnsOf(leg, legAngles(joints, leg));
  }
  return turns;
}

Point3<Torso> footPosition(LegId leg, const LegTurns& turns) {
  return ofLowerLeg(leg, turns, planeFoot(turns.knee, lowerLength(leg)));
}

Point3<Torso> footPosition(LegId leg, const LegAngles& angles) {
  return footPosition(leg, turnsOf(leg, angles));
}

LegId legOfSupport(std::size_t i) {
  if (i < kLegCount) return static_cast<LegId>(i);
  return i == kLegCount ? LegId::leftFront : LegId::rightFront;
}

Support supportOf(std::size_t i, const LegTurns& turns) {
  const LegId leg = legOfSupport(i);
  const bool paw = i < kLegCount;
  const PlaneFoot plane = paw ? planeFoot(turns.knee, lowerLength(leg) - kPawRadius)
                              : planeFoot(turns.knee, kCowlEnds, -kCowlBehind);
  return {ofLowerLeg(leg, turns, plane), paw ? kPawRadius : kCowlRadius};
}

Support supportOf(std::size_t i, const JointAngles& joints) {
  const LegId leg = legOfSupport(i);
  return supportOf(i, turnsOf(leg, legAngles(joints, leg)));
}

LegSolution reachFoot(LegId leg, Point3<Torso> foot) {
  const Reach wanted = fromTorso(leg, foot);
  const double length = lowerLength(leg);
  const double upper = maths::hypot(kUpperLeg, kKneeForward);
  const double inPlane = maths::square(wanted.x) + maths::square(wanted.y) +
                         maths::square(wanted.z) - maths::square(kKneeOut);
  const double bend = (inPlane - upper * upper - length * length) / (2.0 * upper * length);
  const double knee = maths::atan2(kKneeForward, kUpperLeg) + maths::acos(bend);
  const PlaneFoot plane = planeFoot(maths::sinCos(knee), length);
  const double reach = maths::hypot(plane.y, kKneeOut);
  const double lift = wanted.z / reach;
  const double shoulder = maths::asin(lift) - maths::atan2(kKneeOut, plane.y);
  const maths::SinCos out = maths::sinCos(shoulder);
  const double down = plane.y * out.cos - kKneeOut * out.sin;
  const double rotator = maths::atan2(wanted.x, wanted.y) - maths::atan2(plane.x, down);
  LegSolution solution;
  solution.angles = {Angle::rad(mirrorOf(leg) * rotator), Angle::rad(shoulder), Angle::rad(knee)};
  const LegAngles limited = withinLimits(leg, solution.angles);
  solution.reached = std::fabs(bend) <= 1.0 && std::fabs(lift) <= 1.0 &&
                     limited.rotator == solution.angles.rotator &&
                     limited.shoulder == solution.angles.shoulder &&
                     limited.knee == solution.angles.knee;
  solution.angles = limited;
  return solution;
}

Stance stanceFromLegs(const AllTurns& turns) {
  constexpr double kShortestBase = 1.0;  // cm; contacts nearer than that carry no body
  const Contacts all = contacts(turns);
  Contact front = all[0];
  Contact hind = all[kFrontContacts];
  double best = deepestBelow(all, hind, front, kUnlimited);
  for (std::size_t f = 0; f < kFrontContacts; ++f) {
    for (std::size_t h = kFrontContacts; h < kContactCount; ++h) {
      if (all[f].y - all[h].y < kShortestBase) continue;
      const double below = deepestBelow(all, all[h], all[f], best);
      if (below >= best) continue;
      best = below;
      front = all[f];
      hind = all[h];
    }
  }
  const Angle tilt = Angle::rad(maths::atan2(front.z - hind.z, front.y - hind.y));
  const maths::SinCos lean = tilt.sinCos();
  return {kPawRadius + front.y * lean.sin - front.z * lean.cos, tilt, {}};
}

Stance stanceFromLegs(const JointAngles& joints) { return stanceFromLegs(turnsOf(joints)); }

Point3<Robot> robotFromTorso(const Lean& stance, const Point3<Torso>& p) {
  const maths::SinCos& lean = stance.turn;
  const double y = p.y + kNeckBehindShoulder;
  const double z = p.z - kNeckAboveShoulder;
  const double up = p.z * lean.cos - p.y * lean.sin;
  return {p.x, y * lean.cos + z * lean.sin, stance.shoulderHeight + up};
}

Point3<Torso> torsoFromRobot(const Lean& stance, const Point3<Robot>& p) {
  const maths::SinCos& lean = stance.turn;
  const double forward = p.y - kNeckBehindShoulder * lean.cos + kNeckAboveShoulder * lean.sin;
  const double up = p.z - stance.shoulderHeight;
  return {p.x, forward * lean.cos - up * lean.sin, forward * lean.sin + up * lean.cos};
}

JointAngles withinLimits(const JointAngles& joints) {
  JointAngles limited = joints;
  for (std::size_t j = 0; j < kJointCount; ++j) {
    if (j >= firstJoint(LegId::leftFront) && j <= index(Joint::rightHindKnee)) continue;
    limited.angle[j] = withinRange(kJointRanges[j], joints.angle[j]);
  }
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const auto leg = static_cast<LegId>(i);
    setLegAngles(limited, leg, withinLimits(leg, legAngles(joints, leg)));
  }
  return limited;
}

}  // namespace kelpie::body
