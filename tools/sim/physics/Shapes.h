// SPDX-License-Identifier: Apache-2.0
// The solid parts of a physical robot and the ball as points with a thickness, in field
// coordinates: for drawings, and to measure what a pose covers. What it gives is a copy; the tail
// and the ears, which touch nothing, are not in it.
#pragma once

#include <vector>

#include "tools/sim/physics/Physics.h"

namespace kelpie::sim {

enum class BodyPart : std::uint8_t {
  trunk,
  head,
  jaw,
  leftFront,
  leftHind,
  rightFront,
  rightHind,
  ball
};

// What lies within `radius` of the convex hull of the corners: one of a sphere, two of a rod, eight
// of a box.
struct Shape {
  BodyPart part = BodyPart::trunk;
  std::vector<Point3<Field>> corners;  // cm
  double radius = 0.0;                 // cm
};

std::vector<Shape> shapesOf(const Physics& physics, std::size_t robot);
Shape ballShape(const Physics& physics);

}  // namespace kelpie::sim
