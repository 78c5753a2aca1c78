// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/Shapes.h"

#include <cmath>

#include "tools/viewer/Frames.h"

namespace kelpie::viewer {
namespace {

// Turns the x axis into the direction of v, without a turn about it.
foxglove::Quaternion along(const foxglove::Vector3& v) {
  const double flat = std::hypot(v.x(), v.y());
  const double yaw = 0.5 * std::atan2(v.y(), v.x());
  const double pitch = -0.5 * std::atan2(v.z(), flat);
  foxglove::Quaternion q;
  q.set_x(-std::sin(pitch) * std::sin(yaw));
  q.set_y(std::sin(pitch) * std::cos(yaw));
  q.set_z(std::cos(pitch) * std::sin(yaw));
  q.set_w(std::cos(pitch) * std::cos(yaw));
  return q;
}

foxglove::Vector3 sizeOf(double x, double y, double z) {
  foxglove::Vector3 size;
  size.set_x(x);
  size.set_y(y);
  size.set_z(z);
  return size;
}

}  // namespace

foxglove::Color colour(double r, double g, double b, double a) {
  foxglove::Color c;
  c.set_r(r);
  c.set_g(g);
  c.set_b(b);
  c.set_a(a);
  return c;
}

foxglove::Color colourOf(TeamColour team) {
  return team == TeamColour::red ? colour(0.85, 0.15, 0.15) : colour(0.15, 0.3, 0.9);
}

foxglove::Color colourOf(LandmarkKind kind) {
  switch (kind) {
    case LandmarkKind::goalBlue: return colour(0.1, 0.4, 0.95);
    case LandmarkKind::goalYellow: return colour(1.0, 0.85, 0.0);
    default: return colour(1.0, 0.4, 0.75);
  }
}

foxglove::Color colourOf(LinePointKind kind) {
  switch (kind) {
    case LinePointKind::line: return colour(1.0, 1.0, 0.0);
    case LinePointKind::border: return colour(0.0, 1.0, 1.0);
    default: return colour(0.45, 1.0, 0.45);
  }
}

foxglove::Color ballColour() { return colour(1.0, 0.5, 0.0); }
foxglove::Color white() { return colour(1.0, 1.0, 1.0); }

foxglove::SceneEntity entity(TimeUs time, const std::string& frame, const std::string& id) {
  foxglove::SceneEntity result;
  *result.mutable_timestamp() = stampOf(time);
  result.set_frame_id(frame);
  result.set_id(id);
  result.mutable_lifetime();  // 0: no end
  result.set_frame_locked(true);
  return result;
}

void addBox(foxglove::SceneEntity& to, const foxglove::Pose& pose, const foxglove::Vector3& size,
            const foxglove::Color& colour) {
  foxglove::CubePrimitive& cube = *to.add_cubes();
  *cube.mutable_pose() = pose;
  *cube.mutable_size() = size;
  *cube.mutable_color() = colour;
}

void addBar(foxglove::SceneEntity& to, const foxglove::Vector3& from, const foxglove::Vector3& end,
            double thickness, const foxglove::Color& colour) {
  const auto way = sizeOf(end.x() - from.x(), end.y() - from.y(), end.z() - from.z());
  const double length = std::hypot(way.x(), way.y(), way.z());
  foxglove::Pose pose = poseAt(
      sizeOf(0.5 * (from.x() + end.x()), 0.5 * (from.y() + end.y()), 0.5 * (from.z() + end.z())));
  *pose.mutable_orientation() = along(way);
  addBox(to, pose, sizeOf(length, thickness, thickness), colour);
}

void addBall(foxglove::SceneEntity& to, const foxglove::Vector3& middle, double radius,
             const foxglove::Color& colour) {
  foxglove::SpherePrimitive& sphere = *to.add_spheres();
  *sphere.mutable_pose() = poseAt(middle);
  *sphere.mutable_size() = sizeOf(2.0 * radius, 2.0 * radius, 2.0 * radius);
  *sphere.mutable_color() = colour;
}

void addCylinder(foxglove::SceneEntity& to, const foxglove::Vector3& middle, double radius,
                 double height, const foxglove::Color& colour) {
  foxglove::CylinderPrimitive& cylinder = *to.add_cylinders();
  *cylinder.mutable_pose() = poseAt(middle);
  *cylinder.mutable_size() = sizeOf(2.0 * radius, 2.0 * radius, height);
  cylinder.set_bottom_scale(1.0);
  cylinder.set_top_scale(1.0);
  *cylinder.mutable_color() = colour;
}

void addLines(foxglove::SceneEntity& to, foxglove::LinePrimitive::Type type, double thickness,
              const std::vector<foxglove::Vector3>& points, const foxglove::Color& colour) {
  foxglove::LinePrimitive& line = *to.add_lines();
  line.set_type(type);
  *line.mutable_pose() = poseAt({});
  line.set_thickness(thickness);
  for (const foxglove::Vector3& p : points) {
    foxglove::Point3& point = *line.add_points();
    point.set_x(p.x());
    point.set_y(p.y());
    point.set_z(p.z());
  }
  *line.mutable_color() = colour;
}

void addArrow(foxglove::SceneEntity& to, const foxglove::Pose& pose, double length,
              const foxglove::Color& colour) {
  constexpr double kHead = 0.3;  // of the length
  foxglove::ArrowPrimitive& arrow = *to.add_arrows();
  *arrow.mutable_pose() = pose;
  arrow.set_shaft_length((1.0 - kHead) * length);
  arrow.set_shaft_diameter(0.02);
  arrow.set_head_length(kHead * length);
  arrow.set_head_diameter(0.05);
  *arrow.mutable_color() = colour;
}

void addText(foxglove::SceneEntity& to, const foxglove::Vector3& where, double size,
             const std::string& text, const foxglove::Color& colour) {
  foxglove::TextPrimitive& words = *to.add_texts();
  *words.mutable_pose() = poseAt(where);
  words.set_billboard(true);
  words.set_font_size(size);
  *words.mutable_color() = colour;
  words.set_text(text);
}

}  // namespace kelpie::viewer
