// SPDX-License-Identifier: Apache-2.0
// The frames of reference, stated once, and points and poses that carry their frame.
//
//   Field   origin at the corner left of the own goal seen from it; x across the field to the right
//           (0..360), y up-field (0..540), z up; headings counter-clockwise from +x, so 90 deg
//           looks at the opponent goal. The own goal is at y = 0 whatever the team colour.
//   Robot   origin on the ground below the neck base; x right, y forward, z up; headings and turns
//           positive to the left, 0 = straight ahead (checklist H02).
//
//   Camera  origin in the camera; x right and y down in the image, z along the optical axis.
//
//   Pixel   208 x 160, x right, y down, origin at the top left corner of the top left pixel; the
//           centre of pixel (i, j) is (i + 0.5, j + 0.5).
//
//   Torso   origin at the middle of the front shoulder axis; leans with the body
//           (robot/body/Legs.h).
//
// Lengths are centimetres. Transforms read target from source: fieldFromRobot(pose, point).
#pragma once

#include "robot/core/Angle.h"
#include "robot/core/Maths.h"
#include "robot/core/fields/Fields.h"

namespace kelpie {

struct Field {};
struct Robot {};
struct Camera {};

template <class Frame>
struct Point2 {
  double x = 0.0;
  double y = 0.0;

  double norm() const { return maths::hypot(x, y); }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("x", &Point2::x, "cm"), field("y", &Point2::y, "cm"));
  }
};

template <class Frame>
Point2<Frame> operator+(Point2<Frame> a, Point2<Frame> b) {
  return {a.x + b.x, a.y + b.y};
}
template <class Frame>
Point2<Frame> operator-(Point2<Frame> a, Point2<Frame> b) {
  return {a.x - b.x, a.y - b.y};
}
template <class Frame>
Point2<Frame> operator*(Point2<Frame> a, double factor) {
  return {a.x * factor, a.y * factor};
}
template <class Frame>
double distance(Point2<Frame> a, Point2<Frame> b) {
  return (a - b).norm();
}

template <class Frame>
struct Point3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("x", &Point3::x, "cm"), field("y", &Point3::y, "cm"),
                     field("z", &Point3::z, "cm"));
  }
};

template <class Frame>
Point3<Frame> operator+(Point3<Frame> a, Point3<Frame> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Frame>
Point3<Frame> operator-(Point3<Frame> a, Point3<Frame> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

struct PixelPoint {
  double x = 0.0;
  double y = 0.0;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("x", &PixelPoint::x, "px"), field("y", &PixelPoint::y, "px"));
  }
};

// A robot's place on the field: where its neck base stands and which way its body points.
struct Pose2 {
  Point2<Field> position;
  Angle heading;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("position", &Pose2::position), field("heading", &Pose2::heading));
  }
};

// Direction of a point seen from the robot: 0 ahead, left positive.
inline Angle bearing(Point2<Robot> p) { return Angle::rad(maths::atan2(-p.x, p.y)); }

inline Point2<Robot> robotPolar(double distance, Angle heading) {
  const maths::SinCos h = heading.sinCos();
  return {-distance * h.sin, distance * h.cos};
}

// Thesis 2004 equation 3.12: g = R(h - pi/2) l + (x, y).
inline Point2<Field> fieldFromRobot(const Pose2& pose, Point2<Robot> p) {
  const maths::SinCos h = pose.heading.sinCos();
  return {pose.position.x + h.sin * p.x + h.cos * p.y, pose.position.y - h.cos * p.x + h.sin * p.y};
}

inline Point2<Robot> robotFromField(const Pose2& pose, Point2<Field> p) {
  const maths::SinCos h = pose.heading.sinCos();
  const Point2<Field> d = p - pose.position;
  return {h.sin * d.x - h.cos * d.y, h.cos * d.x + h.sin * d.y};
}

}  // namespace kelpie
