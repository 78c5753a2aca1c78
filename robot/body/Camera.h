// SPDX-License-Identifier: Apache-2.0
// The head chain and the camera as exact geometry: where the camera is for given joints and stance,
// which ground point a pixel sees, and which pixel a point falls on. Pinhole with square pixels and
// a focal length of 192 px (facts-2005 section 2.1); lens errors are the ring correction's
// business.
#pragma once

#include <cstddef>
#include <optional>

#include "robot/core/FrameInput.h"
#include "robot/core/Geometry.h"
#include "robot/core/Percepts.h"

namespace kelpie::body {

constexpr double kFocalLength = 192.0;  // px
constexpr double kPrincipalX = 104.0;   // px
constexpr double kPrincipalY = 80.0;    // px

struct BodyParams {
  Angle neckTiltOffset;  // joint play and zero errors of this robot, added to what is sensed
  Angle headPanOffset;
  Angle headNodOffset;
  Angle bodyTiltOffset;

  static constexpr auto fields() {
    return fieldList(field("neckTiltOffset", &BodyParams::neckTiltOffset, "rad", -10, 10),
                     field("headPanOffset", &BodyParams::headPanOffset, "rad", -10, 10),
                     field("headNodOffset", &BodyParams::headNodOffset, "rad", -10, 10),
                     field("bodyTiltOffset", &BodyParams::bodyTiltOffset, "rad", -10, 10));
  }
};

// Camera pose in the robot frame. Joints: neckTilt, headPan, headNod of `joints`.
CameraPose cameraPose(const JointAngles& joints, const Stance& stance);

// Unit vector, in the robot frame, of the ray through a pixel.
Point3<Robot> rayThrough(const CameraPose& camera, PixelPoint pixel);

// Where the ray through the pixel meets the plane z = height; nothing if it does not descend to it.
std::optional<Point2<Robot>> groundPoint(const CameraPose& camera, PixelPoint pixel,
                                         double height = 0.0);

// Ground points of many pixels at once. Those that do not meet the plane are left with valid[i] =
// false.
void groundPoints(const CameraPose& camera, const PixelPoint* pixels, std::size_t count,
                  Point2<Robot>* points, bool* valid, double height = 0.0);

// The pixel a point falls on, inside the image or not; nothing if it is behind the camera.
std::optional<PixelPoint> project(const CameraPose& camera, Point3<Robot> point);
void project(const CameraPose& camera, const Point3<Robot>* points, std::size_t count,
             PixelPoint* pixels, bool* valid);

Horizon horizon(const CameraPose& camera);

// rad a frame, the fastest of the head's three joints.
double headSpeed(const HeadRate& rate);

// First stage of the camera loop.
BodyState step(const FrameInput& input, const BodyParams& params);

}  // namespace kelpie::body
