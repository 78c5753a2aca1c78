// SPDX-License-Identifier: Apache-2.0
// Where the carpet really ends in a rendered view: the projection of its border through the true
// camera of every column, and whether something stands before it there.
#pragma once

#include <array>

#include "tools/experiments/views/View.h"

namespace kelpie::experiments {

constexpr int kNoBorder = -1;

struct EdgeColumn {
  double row = -1e6;       // upper end of the carpet; -1e6: it leaves through the image's top
  int border = kNoBorder;  // 0 left, 1 right, 2 own end, 3 far end; kNoBorder: not in the image
  bool hidden = false;     // by a robot, a goal, a beacon or the ball
};

struct EdgeTruth {
  std::array<EdgeColumn, kImageWidth> column{};
  int inImage = 0;                     // columns with the edge in the image
  int shown = 0;                       // of these, those with nothing before it
  std::array<int, 4> borderColumns{};  // of these, for each border
};

EdgeTruth edgeTruth(const View& view);

// Row of the horizon at a column's middle.
double horizonTruth(const View& view, int column);

}  // namespace kelpie::experiments
