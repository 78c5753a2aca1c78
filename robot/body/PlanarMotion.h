// SPDX-License-Identifier: Apache-2.0
// The rigid motion of the ground plane that brings points from where they were to where they are,
// with the least squares.
#pragma once

#include <cstddef>

#include "robot/core/types/Geometry.h"

namespace kelpie::body {

struct PlanarMotion {
  double x = 0.0;     // cm, to the right
  double y = 0.0;     // cm, ahead
  double turn = 0.0;  // rad, to the left
};

// Of no points no motion, of one a shift.
PlanarMotion rigidMotion(const Point2<Robot>* from, const Point2<Robot>* to, std::size_t count);

}  // namespace kelpie::body
