// SPDX-License-Identifier: Apache-2.0
// The outer wall of the 2004 localisation challenge and the sheets of paper on it (thesis 2004
// section 4.1.1: white A4 sheets with coloured papers, at least six, of 10 to 50 cm, at least three
// with pink of 10 cm or more). Everything about the sheets is drawn from a seed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "robot/core/Random.h"
#include "tools/sim/camera/Scene.h"

namespace kelpie::sim {

// A coloured paper on a sheet; lengths from the sheet's lower left corner, seen from the field.
struct Paper {
  double left = 0.0;
  double right = 0.0;
  double low = 0.0;  // cm above the ground
  double high = 0.0;
  Colour colour;
  bool pink = false;
};

struct WallSheet {
  std::size_t side = 0;  // of the wall: from corner `side` to the next
  double at = 0.0;       // cm along it to the sheet's lower left corner
  double width = 21.0;
  double low = 0.0;  // cm above the ground
  double high = 29.7;
  std::vector<Paper> papers;
};

// Corners go round as seen from above, so that each side's left end comes last: counter-clockwise.
struct OuterWall {
  std::array<Point2<Field>, 4> corners{};
  double height = 30.0;  // checklist K02
  std::vector<WallSheet> sheets;
};

// 15 cm beyond the carpet; each corner up to `slant` cm to the side, so that it is no rectangle.
OuterWall outerWall(const body::FieldDescription& field, double slant, std::uint64_t seed);

// Middles of the pink papers on the ground plan.
std::vector<Point2<Field>> pinkPlaces(const OuterWall& wall);

void addWall(Scene& scene, const OuterWall& wall);

// Takes the beacons away and covers the goals with white.
void hideLandmarks(Scene& scene);

}  // namespace kelpie::sim
