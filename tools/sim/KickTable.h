// SPDX-License-Identifier: Apache-2.0
// What kicks do with the ball, from each place: pycode/lib/kick_map.py, which `kelpie calibrate
// kicks` measured on varied physical models, compiled in (compile_kicks.py). Between its places
// bilinear, each counting for direction and distance by the share of its balls that went; a step
// beyond the outermost ones no ball goes any more. Fails for a ball that rolls.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "robot/core/Command.h"
#include "robot/core/Geometry.h"

namespace kelpie::sim {

// As the map has it. All but the chance are of balls that go.
struct KickCell {
  double chance;             // percent of the balls that went further than kGoes
  double direction, sd;      // deg left of straight ahead
  double distance, reachSd;  // cm
};
constexpr double kGoes = 30.0;  // cm

// Of a left kick, or of one that is its own mirror image: such a one has the places at its right.
struct KickGrid {
  MotionKind kind;
  bool walks;              // until its kick begins; else it stands
  double leftmost, aside;  // cm to the right, and from place to place
  std::size_t columns;
  double nearest, ahead;  // cm
  std::size_t rows;
  std::vector<KickCell> cells;  // a row for each distance
};
struct HeldKick {
  MotionKind kind;
  KickCell cell;
};
const std::vector<KickGrid>& kickGrids();
const std::vector<HeldKick>& heldKicks();

// Of a ball that lies there, in the frame of the robot as its kick begins, or that it holds;
// nothing for a motion that the map does not know so.
std::optional<KickCell> freeKick(MotionKind kind, bool walks, Point2<Robot> ball);
std::optional<KickCell> heldKick(MotionKind kind);

}  // namespace kelpie::sim
