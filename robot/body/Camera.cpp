// SPDX-License-Identifier: Apache-2.0
#include "robot/body/Camera.h"

#include <cmath>

#include "robot/body/Ers7.h"

namespace kelpie::body {
namespace {

// facts-2005 section 2.2, in cm.
constexpr double kNeckLength = 8.0;
constexpr double kFaceLength = 8.106;
constexpr double kCameraDrop = 1.46;
constexpr double kFarRow = 1e4;  // px; a horizon outside the image ends here

Point3<Robot> along(Point3<Robot> from, const Point3<Robot>& axis, double way) {
  return {from.x + axis.x * way, from.y + axis.y * way, from.z + axis.z * way};
}

// a * ca + b * cb, to turn axes in their plane.
Point3<Robot> mixed(const Point3<Robot>& a, double ca, const Point3<Robot>& b, double cb) {
  return {a.x * ca + b.x * cb, a.y * ca + b.y * cb, a.z * ca + b.z * cb};
}

// Camera coordinates of a robot-frame vector.
Point3<Camera> inCamera(const CameraPose& camera, const Point3<Robot>& v) {
  const auto& a = camera.axes;
  return {a[0] * v.x + a[3] * v.y + a[6] * v.z, a[1] * v.x + a[4] * v.y + a[7] * v.z,
          a[2] * v.x + a[5] * v.y + a[8] * v.z};
}

// facts-2005 section 6.4 (there confirmed over five frames, which needs a memory). Instead gravity
// must have left the body's vertical: below 500 of 981 cm/s2 fits any reading of 850 along or
// across (root of 981^2 - 850^2 = 490), and a jolt of the walk leaves it above.
bool lies(const std::array<double, 3>& acceleration) {
  constexpr double kOnItsTail = 860.0;
  constexpr double kOnItsNose = -850.0;
  constexpr double kOnItsRight = 900.0;
  constexpr double kOnItsLeft = -860.0;
  constexpr double kUpsideDown = -650.0;
  constexpr double kUpright = 500.0;
  const auto [forward, left, up] = acceleration;
  if (up > kUpright) return false;
  return up < kUpsideDown || forward > kOnItsTail || forward < kOnItsNose || left > kOnItsRight ||
         left < kOnItsLeft;
}

double clampedRow(double row) { return maths::clamp(row, -kFarRow, kFarRow); }

}  // namespace

CameraPose cameraPose(const JointAngles& joints, const Stance& stance) {
  const maths::SinCos lean = maths::sinCos(stance.bodyTilt.rad());
  const double neckHeight =
      stance.shoulderHeight + kNeckAboveShoulder * lean.cos + kNeckBehindShoulder * lean.sin;
  const maths::SinCos tilt = maths::sinCos((joints[Joint::neckTilt] - stance.bodyTilt).rad());
  const maths::SinCos pan = maths::sinCos(joints[Joint::headPan].rad());
  const maths::SinCos nod = maths::sinCos(joints[Joint::headNod].rad());
  // Neck: leans back for positive tilt; the pan axis is along it.
  const Point3<Robot> neckUp{0.0, -tilt.sin, tilt.cos};
  const Point3<Robot> neckForward{0.0, tilt.cos, tilt.sin};
  const Point3<Robot> right{1.0, 0.0, 0.0};
  const Point3<Robot> faceRight = mixed(right, pan.cos, neckForward, pan.sin);
  const Point3<Robot> faceLevel = mixed(neckForward, pan.cos, right, -pan.sin);
  const Point3<Robot> forward = mixed(faceLevel, nod.cos, neckUp, nod.sin);
  const Point3<Robot> up = mixed(neckUp, nod.cos, faceLevel, -nod.sin);

  const Point3<Robot> nodAxis = along({0.0, 0.0, neckHeight}, neckUp, kNeckLength);
  CameraPose pose;
  pose.position = along(along(nodAxis, forward, kFaceLength), up, -kCameraDrop);
  pose.axes = {faceRight.x, -up.x,       forward.x, faceRight.y, -up.y,
               forward.y,   faceRight.z, -up.z,     forward.z};
  return pose;
}

Point3<Robot> rayThrough(const CameraPose& camera, PixelPoint pixel) {
  const double x = pixel.x - kPrincipalX;
  const double y = pixel.y - kPrincipalY;
  const double length = std::sqrt(x * x + y * y + kFocalLength * kFocalLength);
  const auto& a = camera.axes;
  return {(a[0] * x + a[1] * y + a[2] * kFocalLength) / length,
          (a[3] * x + a[4] * y + a[5] * kFocalLength) / length,
          (a[6] * x + a[7] * y + a[8] * kFocalLength) / length};
}

std::optional<Point2<Robot>> groundPoint(const CameraPose& camera, PixelPoint pixel,
                                         double height) {
  const Point3<Robot> ray = rayThrough(camera, pixel);
  const double drop = height - camera.position.z;
  if (!(ray.z < 0.0 && drop < 0.0)) return std::nullopt;
  const double way = drop / ray.z;
  return Point2<Robot>{camera.position.x + way * ray.x, camera.position.y + way * ray.y};
}

void groundPoints(const CameraPose& camera, const PixelPoint* pixels, std::size_t count,
                  Point2<Robot>* points, bool* valid, double height) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto point = groundPoint(camera, pixels[i], height);
    valid[i] = point.has_value();
    if (point) points[i] = *point;
  }
}

std::optional<PixelPoint> project(const CameraPose& camera, Point3<Robot> point) {
  const Point3<Camera> p = inCamera(camera, point - camera.position);
  if (!(p.z > 1e-6)) return std::nullopt;
  return PixelPoint{kPrincipalX + kFocalLength * p.x / p.z, kPrincipalY + kFocalLength * p.y / p.z};
}

void project(const CameraPose& camera, const Point3<Robot>* points, std::size_t count,
             PixelPoint* pixels, bool* valid) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto pixel = project(camera, points[i]);
    valid[i] = pixel.has_value();
    if (pixel) pixels[i] = *pixel;
  }
}

Horizon horizon(const CameraPose& camera) {
  // Directions (x, y, f) in the camera without a vertical part: row 2 of the axes times them is 0.
  const double zx = camera.axes[6];
  const double zy = camera.axes[7];
  const double zf = camera.axes[8] * kFocalLength;
  const auto row = [&](double column) {
    const double rest = zx * (column - kPrincipalX) + zf;
    if (std::fabs(zy) < 1e-9) return rest > 0.0 ? kFarRow : -kFarRow;
    return clampedRow(kPrincipalY - rest / zy);
  };
  return {row(0.0), row(kImageWidth)};
}

BodyState step(const FrameInput& input, const BodyParams& params) {
  JointAngles joints = input.sensors.joints;
  joints[Joint::neckTilt] = joints[Joint::neckTilt] + params.neckTiltOffset;
  joints[Joint::headPan] = joints[Joint::headPan] + params.headPanOffset;
  joints[Joint::headNod] = joints[Joint::headNod] + params.headNodOffset;
  Stance stance = input.stance;
  stance.bodyTilt = stance.bodyTilt + params.bodyTiltOffset;

  BodyState state;
  state.camera = cameraPose(joints, stance);
  state.horizon = horizon(state.camera);
  const HeadRate& rate = input.headRate;
  state.headSpeed =
      kFrameSeconds * std::fmax(std::fabs(rate.neckTilt),
                                std::fmax(std::fabs(rate.headPan), std::fabs(rate.headNod)));
  state.fallen = lies(input.sensors.acceleration);
  return state;
}

}  // namespace kelpie::body
