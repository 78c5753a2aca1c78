// SPDX-License-Identifier: Apache-2.0
// The shape of a robot's head and legs, as spheres at the places that its joints give them: what
// the ball can hit, what a paw can push into, and what of itself a robot can see. Where the joints
// are comes from robot/body; only the thickness of the parts is said here.
#pragma once

#include <array>
#include <vector>

#include "robot/body/Legs.h"
#include "tools/sim/camera/Scene.h"

namespace kelpie::sim {

// How the body is really turned beside what its stance says, about the neck base: first by `tilt`,
// which lowers the nose as Stance::bodyTilt does, then by `roll`, which lifts the left side. Legs
// are left where the joints have them.
struct Lean {
  Angle tilt;
  Angle roll;

  bool level() const { return tilt.rad() == 0.0 && roll.rad() == 0.0; }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("tilt", &Lean::tilt, "rad", -45, 45),
                     field("roll", &Lean::roll, "rad", -45, 45));
  }
};

// What of the body matters to camera and contacts at one time.
struct BodyPlace {
  Pose2 pose;
  Stance stance;
  JointAngles joints;
  Lean lean;
};

// A direction, and a point, that are fixed to the body and would be there if it did not lean.
Point3<Robot> leanedVector(const Lean& lean, Point3<Robot> v);
Point3<Robot> leanedPoint(const BodyPlace& place, Point3<Robot> p);
// The camera as it really is.
CameraPose trueCamera(const BodyPlace& place);

struct PartSphere {
  FieldPoint3 centre;
  double radius = 0.0;
};

// Four paws in the order of LegId, then knee and middle of the lower leg of each front leg, then
// the head.
using BodyParts = std::array<PartSphere, 9>;
constexpr std::size_t kLeftShin = 5;
constexpr std::size_t kRightShin = 7;
BodyParts bodyParts(const BodyPlace& place);

// The pose a robot is switched on in: lying low on bent legs.
JointAngles startingPose();

using Feet = std::array<Point3<Robot>, kLegCount>;  // where the legs touch the ground
Feet feetOf(const JointAngles& joints, const Stance& stance);

Point3<Torso> kneePosition(LegId leg, const body::LegAngles& angles);

// Turns the front legs' joints so that the feet, left and right, stand there.
void setFrontFeet(JointAngles& joints, const Stance& stance, std::array<Point2<Robot>, 2> feet);

// The front legs as their own robot's camera sees them, white above the knee and grey below. The
// rest of a robot never comes into its own view: trunk and hind legs are behind the camera's, and
// the jaw below it.
std::vector<Limb> frontLegs(const BodyPlace& place);

}  // namespace kelpie::sim
