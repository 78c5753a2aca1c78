// SPDX-License-Identifier: Apache-2.0
#include "actuator/motion/Gaze.h"

#include "robot/body/Ers7.h"
#include "robot/body/Legs.h"

namespace kelpie::actuator {
namespace {

constexpr double kNodShare = 0.35;     // of a pitch below the body's plane
constexpr double kLowestNeck = -32.0;  // deg; lower, and the chin touches a ball of 8.4 cm
constexpr double kLowestNod = -5.0;    // deg, with the neck that high (openr.md 5.6)

// How far the neck bends for a view that is so much above the body's plane.
Angle neckFor(double pitchDeg) {
  if (!(pitchDeg < 0.0)) return Angle();
  const double nod = maths::clamp(kNodShare * pitchDeg, kLowestNod, 0.0);
  return Angle::deg(maths::clamp(pitchDeg - nod, kLowestNeck, 0.0));
}

// Along the neck when it is bent so far: components of a robot-frame vector to the right, ahead and
// up.
Point3<Robot> inNeck(const Point3<Robot>& v, double tilt) {
  const maths::SinCos t = maths::sinCos(tilt);
  return {v.x, v.y * t.cos + v.z * t.sin, v.z * t.cos - v.y * t.sin};
}

void pointAlong(const Point3<Robot>& way, Angle neck, double drop, HeadRequest& joints) {
  const double level = maths::hypot(way.x, way.y);
  const double far = maths::hypot(level, way.z);
  joints.neckTilt = neck;
  joints.headPan = Angle::rad(maths::atan2(-way.x, way.y));
  // The camera hangs below the nod axis: it looks up by as much.
  const double up = far > drop ? maths::asin(drop / far) : 0.0;
  joints.headNod = Angle::rad(maths::atan2(way.z, level) + up);
}

void lookAlong(const Stance& stance, HeadRequest& joints) {
  const maths::SinCos up = maths::sinCos(joints.elevation.rad());
  const Point3<Robot> way{-joints.direction.sin() * up.cos, joints.direction.cos() * up.cos,
                          up.sin};
  const Angle neck = neckFor((joints.elevation + stance.bodyTilt).deg());
  pointAlong(inNeck(way, (neck - stance.bodyTilt).rad()), neck, 0.0, joints);
}

// The neck that the answer asks for moves the nod axis: three rounds leave less than 0.1 deg.
void lookAt(const Stance& stance, HeadRequest& joints) {
  constexpr int kRounds = 3;
  const Point3<Robot> base =
      body::robotFromTorso(stance, {0.0, -body::kNeckBehindShoulder, body::kNeckAboveShoulder});
  Angle neck;
  for (int i = 0; i < kRounds; ++i) {
    const double tilt = (neck - stance.bodyTilt).rad();
    Point3<Robot> way = inNeck(joints.target - base, tilt);
    way.z -= body::kNeckLength;
    pointAlong(way, neck, body::kCameraDrop, joints);
    const double pitch = neck.deg() + joints.headNod.deg();
    if (i + 1 < kRounds) neck = neckFor(pitch);
  }
}

}  // namespace

HeadRequest asJoints(const HeadRequest& request, const Stance& stance) {
  HeadRequest joints = request;
  joints.aim = HeadAim::joints;
  if (request.aim == HeadAim::direction) lookAlong(stance, joints);
  if (request.aim == HeadAim::point) lookAt(stance, joints);
  return joints;
}

}  // namespace kelpie::actuator
