// SPDX-License-Identifier: Apache-2.0
// The ray through a pixel as a direction on the ground and a slope: what beacons and goals need of
// the camera geometry.
#pragma once

#include <cmath>

#include "robot/body/Camera.h"
#include "robot/core/Maths.h"
#include "robot/core/types/Geometry.h"

namespace kelpie::vision {

struct GroundRay {
  double right = 0.0;  // unit vector on the ground towards the pixel
  double forward = 1.0;
  double slope = 0.0;  // tangent of the elevation
};

// Of a ray of any length; one that is vertical has no direction on the ground.
inline GroundRay alongGround(const Point3<Robot>& ray) {
  const double along = std::sqrt(ray.x * ray.x + ray.y * ray.y);
  constexpr double kMinAlong = 1e-6;
  constexpr double kVerticalSlope = 1e6;
  if (along < kMinAlong) return {0.0, 1.0, ray.z > 0.0 ? kVerticalSlope : -kVerticalSlope};
  const double perLength = 1.0 / along;
  return {ray.x * perLength, ray.y * perLength, ray.z * perLength};
}

inline GroundRay groundRayThrough(const CameraPose& camera, PixelPoint pixel) {
  return alongGround(body::wayThrough(camera, pixel));
}

// The ground point at a distance from the camera in the ray's direction.
inline Point2<Robot> placeAt(const CameraPose& camera, const GroundRay& ray, double distance) {
  return {camera.position.x + distance * ray.right, camera.position.y + distance * ray.forward};
}

// The root of 2: two ends, whose errors do not depend on each other.
constexpr double kRootTwo = 1.414;

// Standard deviation of a distance d from the angle that `height` fills, each end uncertain by
// `edgeSd` pixels.
inline double sizeSd(const CameraPose& camera, double d, double height, double edgeSd) {
  return d * d / height * kRootTwo * edgeSd / camera.lens.focalLength;
}

}  // namespace kelpie::vision
