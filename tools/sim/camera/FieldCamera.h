// SPDX-License-Identifier: Apache-2.0
// A camera placed on the field, with the lens that it really has. What an agent believes of its
// lens (robot/body) is its own affair: nothing here comes from there.
#pragma once

#include <array>
#include <optional>

#include "robot/core/types/Percepts.h"
#include "tools/sim/camera/Scene.h"

namespace kelpie::sim {

// Pinhole with square pixels; the nominal one is Sony's (facts-2005 section 2.1).
struct Lens {
  double focal = 192.0;       // px
  double principalX = 104.0;  // px
  double principalY = 80.0;   // px

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("focal", &Lens::focal, "px", 100, 400),
                     field("principalX", &Lens::principalX, "px", 0, 208),
                     field("principalY", &Lens::principalY, "px", 0, 160));
  }
};

// Where it is and its x, y, z axes in the field frame.
struct FieldCamera {
  FieldPoint3 position;
  FieldPoint3 right;
  FieldPoint3 down;
  FieldPoint3 forward;
  Lens lens;
};

FieldCamera fieldCamera(const Pose2& robot, const CameraPose& camera, const Lens& lens = {});

// On the straight way between two that are turned by little: axes are not made longer again, which
// is 1e-5 of them for half a degree. The lens is the first one's.
FieldCamera mixed(const FieldCamera& a, const FieldCamera& b, double share);

// A vector of the robot frame in the field frame.
FieldPoint3 fieldVector(const Pose2& robot, Point3<Robot> v);

// The pixel that a point falls on, inside the image or not; nothing if it is behind the camera.
std::optional<PixelPoint> pixelIn(const FieldCamera& camera, FieldPoint3 point);

using ColumnCameras = std::array<FieldCamera, kImageWidth>;

// When the middle of a column's exposure is, as a share of the frame from 0 to 1. `readout`: the
// share of the frame that passes between the first column and the last; 0 is a global shutter.
double exposedAt(std::size_t column, double readout);

}  // namespace kelpie::sim
