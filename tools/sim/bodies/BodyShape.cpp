// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/bodies/BodyShape.h"

#include "robot/body/Camera.h"
#include "robot/body/Ers7.h"

namespace kelpie::sim {
namespace {

constexpr double kPawRadius = 1.6;
constexpr double kKneeRadius = 2.0;
constexpr double kShinRadius = 1.8;
constexpr double kHeadRadius = 3.8;
constexpr double kHeadBehindCamera = 3.0;

FieldPoint3 onField(const Pose2& pose, Point3<Robot> p) {
  const Point2<Field> ground = fieldFromRobot(pose, {p.x, p.y});
  return {ground.x, ground.y, p.z};
}

Point3<Robot> paw(Point3<Robot> foot) { return foot + Point3<Robot>{0.0, 0.0, kPawRadius}; }

Point3<Robot> kneeOf(const BodyPlace& place, LegId leg) {
  return body::robotFromTorso(place.stance, kneePosition(leg, body::legAngles(place.joints, leg)));
}

Point3<Robot> shoulderOf(const BodyPlace& place, LegId leg) {
  const double side = leg == LegId::rightFront ? 0.5 : -0.5;
  return body::robotFromTorso(place.stance, {side * body::kBodyWidth, 0.0, 0.0});
}

// Its spheres are at most 1.3 cm apart and at least 3.2 cm thick.
Limb limb(const PartSphere& from, const PartSphere& to, Colour colour) {
  Limb limb;
  for (std::size_t i = 0; i < limb.part.size(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(limb.part.size() - 1);
    const FieldPoint3 a = from.centre;
    const FieldPoint3 b = to.centre;
    limb.part[i] = {{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)},
                    from.radius + t * (to.radius - from.radius),
                    colour};
  }
  return limb;
}

Point3<Robot> neckBase(const Stance& stance) {
  return {0.0, 0.0,
          stance.shoulderHeight + body::kNeckAboveShoulder * stance.bodyTilt.cos() +
              body::kNeckBehindShoulder * stance.bodyTilt.sin()};
}

}  // namespace

JointAngles startingPose() {
  JointAngles joints;
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const auto leg = static_cast<LegId>(i);
    const bool front = body::isFront(leg);
    const bool right = leg == LegId::rightFront || leg == LegId::rightHind;
    const double side = right ? 8.5 : -8.5;
    const Point3<Torso> foot =
        front ? Point3<Torso>{side, 1.0, -8.5} : Point3<Torso>{side, -14.0, -9.5};
    body::setLegAngles(joints, leg, body::reachFoot(leg, foot).angles);
  }
  joints[Joint::mouth] = Angle::deg(-3.0);
  joints[Joint::tailTilt] = Angle::deg(20.0);
  return body::withinLimits(joints);
}

Point3<Robot> leanedVector(const Lean& lean, Point3<Robot> v) {
  if (lean.level()) return v;
  const double st = lean.tilt.sin();
  const double ct = lean.tilt.cos();
  const Point3<Robot> tilted{v.x, ct * v.y + st * v.z, ct * v.z - st * v.y};
  const double sr = lean.roll.sin();
  const double cr = lean.roll.cos();
  return {cr * tilted.x + sr * tilted.z, tilted.y, cr * tilted.z - sr * tilted.x};
}

Point3<Robot> leanedPoint(const BodyPlace& place, Point3<Robot> p) {
  if (place.lean.level()) return p;
  const Point3<Robot> base = neckBase(place.stance);
  return base + leanedVector(place.lean, p - base);
}

CameraPose trueCamera(const BodyPlace& place) {
  CameraPose camera = body::cameraPose(place.joints, place.stance);
  if (place.lean.level()) return camera;
  camera.position = leanedPoint(place, camera.position);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3<Robot> axis =
        leanedVector(place.lean, {camera.axes[i], camera.axes[3 + i], camera.axes[6 + i]});
    camera.axes[i] = axis.x;
    camera.axes[3 + i] = axis.y;
    camera.axes[6 + i] = axis.z;
  }
  return camera;
}

Feet feetOf(const JointAngles& joints, const Stance& stance) {
  Feet feet;
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const auto leg = static_cast<LegId>(i);
    feet[i] = body::robotFromTorso(stance, body::footPosition(leg, body::legAngles(joints, leg)));
  }
  return feet;
}

Point3<Torso> kneePosition(LegId leg, const body::LegAngles& angles) {
  const bool front = body::isFront(leg);
  const double mirror = front ? 1.0 : -1.0;
  const double side = leg == LegId::rightFront || leg == LegId::rightHind ? 1.0 : -1.0;
  const double so = angles.shoulder.sin();
  const double co = angles.shoulder.cos();
  const double down = body::kUpperLeg * co - body::kKneeOut * so;
  const double out = body::kUpperLeg * so + body::kKneeOut * co;
  const double sr = mirror * angles.rotator.sin();
  const double cr = angles.rotator.cos();
  const double ahead = body::kKneeForward * cr + down * sr;
  const double below = down * cr - body::kKneeForward * sr;
  return {side * (body::kBodyWidth / 2.0 + out),
          (front ? 0.0 : -body::kBodyLength) + mirror * ahead, -below};
}

BodyParts bodyParts(const BodyPlace& place) {
  BodyParts parts;
  const Feet feet = feetOf(place.joints, place.stance);
  for (std::size_t i = 0; i < kLegCount; ++i)
    parts[i] = {onField(place.pose, paw(feet[i])), kPawRadius};
  std::size_t next = kLegCount;
  for (const LegId leg : {LegId::leftFront, LegId::rightFront}) {
    const Point3<Robot> knee = kneeOf(place, leg);
    parts[next++] = {onField(place.pose, knee), kKneeRadius};
    parts[next++] = {onField(place.pose, between(knee, paw(feet[index(leg)]), 0.5)), kShinRadius};
  }
  const CameraPose camera = trueCamera(place);
  const Point3<Robot> back{-kHeadBehindCamera * camera.axes[2], -kHeadBehindCamera * camera.axes[5],
                           -kHeadBehindCamera * camera.axes[8]};
  parts[next] = {onField(place.pose, camera.position + back), kHeadRadius};
  return parts;
}

void setFrontFeet(JointAngles& joints, const Stance& stance, std::array<Point2<Robot>, 2> feet) {
  const std::array<LegId, 2> legs{LegId::leftFront, LegId::rightFront};
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const auto foot = body::torsoFromRobot(stance, {feet[i].x, feet[i].y, 0.0});
    body::setLegAngles(joints, legs[i], body::reachFoot(legs[i], foot).angles);
  }
}

std::vector<Limb> frontLegs(const BodyPlace& place) {
  std::vector<Limb> limbs;
  const Feet feet = feetOf(place.joints, place.stance);
  for (const LegId leg : {LegId::leftFront, LegId::rightFront}) {
    const PartSphere shoulder{onField(place.pose, shoulderOf(place, leg)), kKneeRadius};
    const PartSphere knee{onField(place.pose, kneeOf(place, leg)), kKneeRadius};
    const PartSphere foot{onField(place.pose, paw(feet[index(leg)])), kPawRadius};
    limbs.push_back(limb(shoulder, knee, colours::kShell));
    limbs.push_back(limb(knee, foot, colours::kGrey));
  }
  return limbs;
}

}  // namespace kelpie::sim
