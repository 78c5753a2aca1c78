// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/camera/FieldCamera.h"

namespace kelpie::sim {
namespace {

double dot(FieldPoint3 a, FieldPoint3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

FieldPoint3 turned(const maths::SinCos& heading, Point3<Robot> v) {
  return {heading.sin * v.x + heading.cos * v.y, heading.sin * v.y - heading.cos * v.x, v.z};
}

}  // namespace

FieldPoint3 fieldVector(const Pose2& robot, Point3<Robot> v) {
  return turned(robot.heading.sinCos(), v);
}

FieldCamera fieldCamera(const Pose2& robot, const CameraPose& camera, const Lens& lens) {
  const maths::SinCos heading = robot.heading.sinCos();
  const auto axis = [&](std::size_t column) {
    return turned(heading, {camera.axes[column], camera.axes[3 + column], camera.axes[6 + column]});
  };
  const double s = heading.sin;
  const double c = heading.cos;
  const Point3<Robot> p = camera.position;
  return {{robot.position.x + s * p.x + c * p.y, robot.position.y + s * p.y - c * p.x, p.z},
          axis(0),
          axis(1),
          axis(2),
          lens};
}

FieldCamera mixed(const FieldCamera& a, const FieldCamera& b, double share) {
  return {between(a.position, b.position, share), between(a.right, b.right, share),
          between(a.down, b.down, share), between(a.forward, b.forward, share), a.lens};
}

std::optional<PixelPoint> pixelIn(const FieldCamera& camera, FieldPoint3 point) {
  const FieldPoint3 way = point - camera.position;
  const double depth = dot(camera.forward, way);
  if (!(depth > 1e-6)) return std::nullopt;
  const Lens& lens = camera.lens;
  return PixelPoint{lens.principalX + lens.focal * dot(camera.right, way) / depth,
                    lens.principalY + lens.focal * dot(camera.down, way) / depth};
}

double exposedAt(std::size_t column, double readout) {
  const double rolling = (static_cast<double>(column) + 0.5) / kImageWidth;
  return readout == 1.0 ? rolling : 0.5 + readout * (rolling - 0.5);
}

}  // namespace kelpie::sim
