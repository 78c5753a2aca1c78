// SPDX-License-Identifier: Apache-2.0
// What each kick does with the ball from each place of it: whether the ball goes, where to, how far
// and how sure all that is. tools/learn measures it, pycode/data/kick_map.py keeps it. A free ball
// lies anywhere within half a step of a grid's place, a held one where the hold has it. Of a pair
// of kicks the left one is there, of a kick that is its own mirror image the places to the right.
// Says nothing of a ball that rolls, nor of a robot that another one pushes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "actuator/motion/MotionData.h"
#include "robot/core/Expected.h"
#include "robot/core/types/Geometry.h"

namespace kelpie::sim {

constexpr double kBallGoes = 30.0;  // cm, a ball that gets no further has not been kicked

// What the robot does until it kicks.
enum class KickFrom : std::uint8_t { standing, walking, hold };
constexpr std::size_t kKickFroms = 3;
constexpr std::array<const char*, kKickFroms> kKickFromNames{"STANDING", "WALKING", "HELD"};

// What a kick does with a ball at one place, of all runs in which a ball could lie there.
struct KickCell {
  int runs = 0;             // none where the robot itself is
  double went = 0.0;        // share of the runs in which the ball went
  Angle direction;          // of its way, mean of those that went
  Angle directionSd;        // about that mean
  double distance = 0.0;    // cm until it lies still
  double distanceSd = 0.0;  // cm
  double fell = 0.0;        // share of the runs
};

// Places that are alike: a ball anywhere in them goes, about the same way.
struct KickWindow {
  Point2<Robot> best;  // the place whose neighbours do best, too
  Point2<Robot> min;   // corners
  Point2<Robot> max;
  KickCell whole;  // over all its places
};

struct KickGrid {
  MotionKind motion = MotionKind::none;
  KickFrom from = KickFrom::standing;  // from the hold: one cell, no places
  std::vector<double> lateral;         // cm to the right, rising
  std::vector<double> ahead;           // cm, rising
  std::vector<KickCell> cells;         // [ahead][lateral]
  KickWindow window;
  double frames = 0.0;      // of 1/30 s
  actuator::MotionWay way;  // of the robot, until it stands again

  const KickCell& cell(std::size_t row, std::size_t column) const {
    return cells[row * lateral.size() + column];
  }
};
using KickMap = std::vector<KickGrid>;

// The kick to the other side; the same if it is its own mirror image.
MotionKind mirrored(MotionKind motion);
inline bool isItsOwnMirror(MotionKind motion) { return mirrored(motion) == motion; }

// Between the places, as pycode/lib/kick_table.py does it: of no runs outside the grid and next to
// a place of no runs.
KickCell cellAt(const KickGrid& grid, Point2<Robot> place);

// Of a text that learn::kickMapText() wrote; nothing else of Python is understood. Of the runs at a
// place it only tells whether there were any.
Expected<KickMap> readKickMap(const std::string& text);

}  // namespace kelpie::sim
