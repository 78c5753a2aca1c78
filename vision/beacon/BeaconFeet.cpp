// SPDX-License-Identifier: Apache-2.0
#include "vision/beacon/BeaconFeet.h"

#include <algorithm>
#include <cmath>

#include "vision/ElevationDoubt.h"

namespace kelpie::vision {
namespace {

constexpr double kMaxGap = 3.0;     // px between samples of one foot, along the horizon
constexpr double kMaxRowGap = 6.0;  // px between them, square to it
constexpr double kMaxFromHorizon =
    60.0;  // px from the horizon: 20 cm of height at 50 cm and an error

bool isWhite(ColourClass c) { return c == ColourClass::white || c == ColourClass::grey; }

bool whiteAt(const Scene& scene, double u, double v) {
  const PixelPoint p = scene.frame.toImage({u, v});
  return Sampler::usable(p) && isWhite(scene.sampler.classAt(p));
}

// White within one or two lattice rows below, and two rows farther still: a highlight is not white.
bool standsOnWhite(const Scene& scene, double u, double v) {
  if (whiteAt(scene, u, v + 2.0)) return whiteAt(scene, u, v + 4.0) || whiteAt(scene, u, v + 6.0);
  return whiteAt(scene, u, v + 4.0) && whiteAt(scene, u, v + 6.0);
}

// Looks runs up by row and column, both growing, as the runs do.
class RunCursor {
 public:
  explicit RunCursor(const RunBuffer& runs) : runs_(runs) {}

  // The last column of the run that covers this one, or one less than the column.
  int coveredTo(int row, int column) {
    while (at_ < runs_.size() && place(runs_[at_].row, runs_[at_].last) < place(row, column)) ++at_;
    const bool covers = at_ < runs_.size() && runs_[at_].row == row && runs_[at_].first <= column;
    return covers ? runs_[at_].last : column - 1;
  }

 private:
  static int place(int row, int column) { return 256 * row + column; }

  const RunBuffer& runs_;
  std::size_t at_ = 0;
};

// Passes the columns of a run below which both of the next two rows have a run of colour too: the
// middle of a goal stands on no white, and one that fills the view has 5000 samples.
class Undersides {
 public:
  explicit Undersides(const RunBuffer& runs) : below_(runs), farther_(runs) {}

  int next(const Run& run, int column) {
    while (column <= run.last) {
      const int covered =
          std::min(below_.coveredTo(run.row + 1, column), farther_.coveredTo(run.row + 2, column));
      if (covered < column) break;
      column = covered + 1;
    }
    return column;
  }

 private:
  RunCursor below_;
  RunCursor farther_;
};

// Rows grow: the first feet that are too high by now need not be looked at again.
std::size_t firstNear(const BeaconFeet& feet, std::size_t first, double v) {
  while (first < feet.size() && v - feet[first].v > kMaxRowGap) ++first;
  return first;
}

void addSample(BeaconFeet& feet, std::size_t first, ColourClass colour, double u, double v) {
  for (std::size_t i = first; i < feet.size(); ++i) {
    BeaconFoot& foot = feet[i];
    if (foot.colour != colour || std::fabs(v - foot.v) > kMaxRowGap) continue;
    if (u < foot.left - kMaxGap || u > foot.right + kMaxGap) continue;
    foot.left = std::min(foot.left, u);
    foot.right = std::max(foot.right, u);
    foot.v = v;
    foot.lowest = std::max(foot.lowest, v);
    ++foot.samples;
    return;
  }
  feet.push_back({colour, u, u, v, v, 1});
}

}  // namespace

BeaconFeet findBeaconFeet(const Scene& scene) {
  BeaconFeet feet;
  const double farthest = kMaxFromHorizon + rowSlack(scene);
  Undersides undersides(scene.runs);
  std::size_t first = 0;
  for (const Run& run : scene.runs) {
    if (run.colour != ColourClass::pink && run.colour != ColourClass::blue &&
        run.colour != ColourClass::yellow)
      continue;
    const double v = scene.lattice.v(run.row);
    const double middle = scene.lattice.u(0.5 * (run.first + run.last));
    if (std::fabs(belowHorizon(scene, scene.frame.toImage({middle, v}))) > farthest) continue;
    first = firstNear(feet, first, v);
    for (int k = run.first; (k = undersides.next(run, k)) <= run.last; ++k) {
      const double u = scene.lattice.u(k);
      if (standsOnWhite(scene, u, v)) addSample(feet, first, run.colour, u, v);
    }
  }
  return feet;
}

}  // namespace kelpie::vision
