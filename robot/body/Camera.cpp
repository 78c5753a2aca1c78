// SPDX-License-Identifier: Apache-2.0
#include "robot/body/Camera.h"

#include <cmath>

#include "robot/body/Ers7.h"

namespace kelpie::body {
namespace {

constexpr int kExposureRounds = 4;
constexpr double kFarRow = 1e4;  // px; a horizon outside the image ends here

double neckHeightOf(const Stance& stance) {
  const maths::SinCos lean = maths::sinCos(stance.bodyTilt.rad());
  return stance.shoulderHeight + kNeckAboveShoulder * lean.cos + kNeckBehindShoulder * lean.sin;
}

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

Point3<Robot> cross(const Point3<Robot>& a, const Point3<Robot>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot(const Point3<Robot>& a, const Point3<Robot>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// How far the axes have turned when column x is exposed, as a small rotation vector.
Point3<Robot> turnAt(const CameraPose& camera, double x) {
  constexpr double kPerWidth = 1.0 / kImageWidth;  // a product: each ray through a pixel asks
  const double share = maths::clamp(x * kPerWidth, -0.5, 1.5) - 0.5;
  return {camera.turn[0] * share, camera.turn[1] * share, camera.turn[2] * share};
}

// Rotation of the camera during one exposure (1/30 s): pan about the neck, neck tilt and nod about
// axes to the right, the body about the vertical.
std::array<double, 3> turnOf(const FrameInput& input, const JointAngles& joints,
                             const CameraPose& camera, const Stance& stance) {
  const maths::SinCos tilt = maths::sinCos((joints[Joint::neckTilt] - stance.bodyTilt).rad());
  const double pan = input.headRate.headPan * kFrameSeconds;
  const double nod = input.headRate.headNod * kFrameSeconds;
  const double elapsed = std::fmax(input.elapsed, 0.5 * kFrameSeconds);
  const double body = input.odometry.turn.rad() * kFrameSeconds / elapsed;
  const auto& a = camera.axes;
  return {nod * a[0] + input.headRate.neckTilt * kFrameSeconds, nod * a[3] - pan * tilt.sin,
          nod * a[6] + pan * tilt.cos + body};
}

// The head's true joints by what is sensed.
JointAngles headJoints(const FrameInput& input, const BodyParams& params) {
  constexpr double kTurns = 0.3;  // rad/s; a neck as fast lies against the side behind it
  JointAngles joints = input.sensors.joints;
  const double lag = 0.5 * maths::clamp(input.headRate.neckTilt / kTurns, -1.0, 1.0);
  Angle& tilt = joints[Joint::neckTilt];
  tilt = Angle::rad((1.0 - params.neckGives) * tilt.rad() - lag * params.neckBacklash.rad()) +
         params.neckTiltOffset;
  joints[Joint::headPan] = joints[Joint::headPan] + params.headPanOffset;
  joints[Joint::headNod] = joints[Joint::headNod] + params.headNodOffset;
  return joints;
}

// Turns the image about its middle.
void rollCamera(Angle roll, CameraPose& camera) {
  auto& a = camera.axes;
  for (std::size_t row = 0; row < 9; row += 3) {
    const double x = a[row];
    const double y = a[row + 1];
    a[row] = roll.cos() * x + roll.sin() * y;
    a[row + 1] = roll.cos() * y - roll.sin() * x;
  }
}

CameraPose cameraOf(const CameraTilt& tilt, const JointAngles& joints, const Stance& stance,
                    const BodyParams& params) {
  CameraTilt lean = tilt;
  lean.roll = lean.roll + params.bodyRollOffset + stance.bodyRoll;
  CameraPose camera = leaning(cameraPose(joints, stance), stance, lean);
  camera.tilt = tilt;
  camera.bodyTiltOffset = params.bodyTiltOffset;
  camera.bodyRollOffset = params.bodyRollOffset;
  camera.lens = params.lens;
  if (params.cameraRollOffset.rad() != 0.0) rollCamera(params.cameraRollOffset, camera);
  return camera;
}

double clampedRow(double row) { return maths::clamp(row, -kFarRow, kFarRow); }

}  // namespace

CameraPose leaning(const CameraPose& camera, const Stance& stance, const CameraTilt& tilt) {
  CameraPose result = camera;
  result.tilt = tilt;
  if (tilt.tilt.rad() == 0.0 && tilt.roll.rad() == 0.0) return result;
  const maths::SinCos up = maths::sinCos(tilt.tilt.rad());
  const maths::SinCos over = maths::sinCos(tilt.roll.rad());
  const double neck = neckHeightOf(stance);
  const auto turn = [&](double& x, double& y, double& z) {
    const double ahead = up.cos * y - up.sin * z;
    const double above = up.sin * y + up.cos * z;
    y = ahead;
    z = over.cos * above - over.sin * x;
    x = over.cos * x + over.sin * above;
  };
  auto& a = result.axes;
  for (std::size_t axis = 0; axis < 3; ++axis) turn(a[axis], a[axis + 3], a[axis + 6]);
  result.position.z -= neck;
  turn(result.position.x, result.position.y, result.position.z);
  result.position.z += neck;
  return result;
}

CameraPose cameraPose(const JointAngles& joints, const Stance& stance) {
  const double neckHeight = neckHeightOf(stance);
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

Point3<Camera> pixelRay(const Lens& lens, PixelPoint pixel) {
  const double x = pixel.x - lens.principalX;
  const double y = pixel.y - lens.principalY;
  if (lens.edgeTerm == 0.0) return {x, y, lens.focalLength};
  const double square = (x * x + y * y) / (lens.focalLength * lens.focalLength);
  const double stretch = 1.0 + lens.edgeTerm * square;
  return {stretch * x, stretch * y, lens.focalLength};
}

PixelPoint pixelOf(const Lens& lens, const Point3<Camera>& ray) {
  constexpr int kRounds = 6;  // each leaves a fifth of the error at an edge term of 0.3
  const double scale = lens.focalLength / ray.z;
  const double x = scale * ray.x;
  const double y = scale * ray.y;
  if (lens.edgeTerm == 0.0) return {lens.principalX + x, lens.principalY + y};
  double stretch = 1.0;
  const double square = (x * x + y * y) / (lens.focalLength * lens.focalLength);
  for (int round = 0; round < kRounds; ++round)
    stretch = 1.0 + lens.edgeTerm * square / (stretch * stretch);
  return {lens.principalX + x / stretch, lens.principalY + y / stretch};
}

double elevationVariance(const CameraTilt& t, double right, double forward) {
  return forward * forward * t.tiltVariance - 2.0 * forward * right * t.covariance +
         right * right * t.rollVariance;
}

Point3<Robot> wayThrough(const CameraPose& camera, PixelPoint pixel) {
  const Point3<Camera> p = pixelRay(camera.lens, pixel);
  const auto& a = camera.axes;
  const Point3<Robot> still{a[0] * p.x + a[1] * p.y + a[2] * p.z,
                            a[3] * p.x + a[4] * p.y + a[5] * p.z,
                            a[6] * p.x + a[7] * p.y + a[8] * p.z};
  return still + cross(turnAt(camera, pixel.x), still);
}

Point3<Robot> rayThrough(const CameraPose& camera, PixelPoint pixel) {
  const Point3<Robot> ray = wayThrough(camera, pixel);
  const double length = std::sqrt(ray.x * ray.x + ray.y * ray.y + ray.z * ray.z);
  return {ray.x / length, ray.y / length, ray.z / length};
}

std::optional<Point2<Robot>> groundPoint(const CameraPose& camera, PixelPoint pixel,
                                         double height) {
  const Point3<Robot> ray = wayThrough(camera, pixel);
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
  const Point3<Robot> way = point - camera.position;
  double column = camera.lens.principalX;
  PixelPoint pixel;
  // Which column sees the point depends on when it is exposed. A turn of 10 deg an image shifts the
  // point by a fifth of what the last round did.
  for (int round = 0; round < kExposureRounds; ++round) {
    // The exact inverse of rayThrough's w + t x w, but for its length: w - t x w alone comes back
    // 0.3 px beside the pixel at 3 rad/s.
    const Point3<Robot> t = turnAt(camera, column);
    const Point3<Robot> unturned = along(way - cross(t, way), t, dot(t, way));
    const Point3<Camera> p = inCamera(camera, unturned);
    if (!(p.z > 1e-6)) return std::nullopt;
    pixel = pixelOf(camera.lens, p);
    if (camera.turn == std::array<double, 3>{}) break;
    column = pixel.x;
  }
  return pixel;
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
  const auto& a = camera.axes;
  const auto row = [&](double column) {
    const Point3<Robot> turn = turnAt(camera, column);
    const double zx = a[6] + turn.x * a[3] - turn.y * a[0];
    const double zy = a[7] + turn.x * a[4] - turn.y * a[1];
    const double zf = (a[8] + turn.x * a[5] - turn.y * a[2]) * camera.lens.focalLength;
    const double rest = zx * (column - camera.lens.principalX) + zf;
    if (std::fabs(zy) < 1e-9) return rest > 0.0 ? kFarRow : -kFarRow;
    return clampedRow(camera.lens.principalY - rest / zy);
  };
  return {row(0.0), row(kImageWidth)};
}

double headSpeed(const HeadRate& rate) {
  return kFrameSeconds * std::fmax(std::fabs(rate.neckTilt),
                                   std::fmax(std::fabs(rate.headPan), std::fabs(rate.headNod)));
}

BodyState step(const FrameInput& input, const BodyParams& params) {
  const JointAngles joints = headJoints(input, params);
  Stance stance = input.stance;
  stance.bodyTilt = stance.bodyTilt + params.bodyTiltOffset;

  BodyState state;
  state.camera = cameraOf(input.cameraTilt, joints, stance, params);
  state.camera.lens.focalLength *= input.focalScale.ratio;
  state.camera.turn = turnOf(input, joints, state.camera, stance);
  for (double& turn : state.camera.turn) turn *= params.lens.readOut;
  state.horizon = horizon(state.camera);
  state.headSpeed = headSpeed(input.headRate);
  state.fallen = lies(input.sensors.acceleration);
  return state;
}

}  // namespace kelpie::body
