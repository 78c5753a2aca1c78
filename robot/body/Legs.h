// SPDX-License-Identifier: Apache-2.0
// The ERS-7's legs: where a foot is for given joint angles, and which angles bring it to a place.
// Front and hind legs are mirror images in shape: a bent front knee brings the paw forward, a bent
// hind knee brings it backward; rotators swing all four forward for positive angles.
// Torso frame: origin at the middle of the front shoulder axis; x right, y forward along the body,
// z up from the back; it leans with the body (facts-2005 section 2.4).
#pragma once

#include <array>
#include <optional>

#include "robot/core/types/Geometry.h"
#include "robot/core/types/Joints.h"
#include "robot/core/types/Motion.h"

namespace kelpie {
struct Torso {};
}  // namespace kelpie

namespace kelpie::body {

constexpr bool isFront(LegId leg) { return leg == LegId::leftFront || leg == LegId::rightFront; }

struct LegAngles {
  Angle rotator;   // J1, swings the leg forward (positive)
  Angle shoulder;  // J2, lifts the leg outwards (positive)
  Angle knee;      // J3, bends the lower leg (positive)
};

LegAngles legAngles(const JointAngles& joints, LegId leg);
void setLegAngles(JointAngles& joints, LegId leg, const LegAngles& angles);

// Sines and cosines of a leg's angles, the rotator's as the leg's side mirrors it: all places of a
// leg follow from them, and they are most of what a place costs.
struct LegTurns {
  maths::SinCos rotator{};
  maths::SinCos shoulder{};
  maths::SinCos knee{};
};
LegTurns turnsOf(LegId leg, const LegAngles& angles);

// The tip of the lower leg.
Point3<Torso> footPosition(LegId leg, const LegTurns& turns);
Point3<Torso> footPosition(LegId leg, const LegAngles& angles);

// What of the legs stands on the ground, as spheres: the four paws in the order of LegId (a leg
// that leans by 45 deg touches the ground 3 mm below its tip), then the elbow cowls of the left and
// the right front leg, on which a robot with bent knees rests.
struct Support {
  Point3<Torso> middle;
  double radius = 0.0;
};
constexpr std::size_t kSupportCount = kLegCount + 2;
Support supportOf(std::size_t i, const LegTurns& turns);
Support supportOf(std::size_t i, const JointAngles& joints);
LegId legOfSupport(std::size_t i);

// The angles that bring the foot to a place; the nearest reachable ones (cosines clamped) and
// `reached` = false when it is out of reach or a joint limit is in the way.
struct LegSolution {
  LegAngles angles;
  bool reached = true;
};
LegSolution reachFoot(LegId leg, Point3<Torso> foot);

// Height of the front shoulder axis and lean of the body, when it stands on the lower of what is in
// front (paws, cowls, chest) and the lower of what is behind (paws, belly). Roll is left out.
using AllTurns = std::array<LegTurns, kLegCount>;
AllTurns turnsOf(const JointAngles& joints);
Stance stanceFromLegs(const AllTurns& turns);
Stance stanceFromLegs(const JointAngles& joints);

// Between the leaning torso and the ground: the robot frame's origin is below the neck base. Of
// many points the sine and cosine of the lean are asked once.
struct Lean {
  explicit Lean(const Stance& stance)
      : shoulderHeight(stance.shoulderHeight), turn(stance.bodyTilt.sinCos()) {}

  double shoulderHeight;
  maths::SinCos turn;
};
Point3<Robot> robotFromTorso(const Lean& lean, const Point3<Torso>& p);
Point3<Torso> torsoFromRobot(const Lean& lean, const Point3<Robot>& p);
inline Point3<Robot> robotFromTorso(const Stance& stance, const Point3<Torso>& p) {
  return robotFromTorso(Lean(stance), p);
}
inline Point3<Torso> torsoFromRobot(const Stance& stance, const Point3<Robot>& p) {
  return torsoFromRobot(Lean(stance), p);
}

// The angle kept inside the joint's soft limits (OPEN-R spec 5.6), the shoulder's coupling to the
// rotator included.
JointAngles withinLimits(const JointAngles& joints);

}  // namespace kelpie::body
