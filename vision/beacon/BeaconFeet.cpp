// SPDX-License-Identifier: Apache-2.0
#include "vision/beacon/BeaconFeet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "vision/ElevationDoubt.h"
#include "vision/pixels/PixelWalk.h"

namespace kelpie::vision {
namespace {

constexpr double kMaxGap = 3.0;     // px between samples of one foot, along the horizon
constexpr double kMaxRowGap = 6.0;  // px between them, square to it
constexpr double kMaxFromHorizon =
    60.0;  // px from the horizon: 20 cm of height at 50 cm and an error

bool isOfBand(ColourClass c) {
  return c == ColourClass::pink || c == ColourClass::blue || c == ColourClass::yellow;
}
bool isWhite(ColourClass c) { return c == ColourClass::white || c == ColourClass::grey; }

// Looks below the samples of one lattice row for white, in whole numbers: a badly known blue makes
// a thousand samples.
class WhiteBelow {
 public:
  WhiteBelow(const Scene& scene, double v) {
    const ImageDirection right = scene.frame.right();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const double below = v + kLatticeStep * (static_cast<double>(i) + 1.0);
      rows_[i] = PixelWalk(scene.frame.toImage({scene.lattice.u(0), below}), right);
    }
  }

  // White in two of the next three rows: a highlight is not white.
  bool at(const Sampler& sampler, int column) const {
    const bool first = white(sampler, column, 0);
    const bool second = white(sampler, column, 1);
    return first == second ? first : white(sampler, column, 2);
  }

 private:
  bool white(const Sampler& sampler, int column, std::size_t row) const {
    const int x = rows_[row].x(kLatticeStep * column);
    const int y = rows_[row].y(kLatticeStep * column);
    return Sampler::usable(x, y) && isWhite(sampler.classAt(x, y));
  }

  std::array<PixelWalk, 3> rows_;
};

// Looks runs up by row and column, both growing, as the runs do.
class RunCursor {
 public:
  explicit RunCursor(const RunBuffer& runs) : at_(runs.begin()), end_(runs.end()) {}

  // The last column of the run that covers this one, or one less than the column.
  int coveredTo(int row, int column) {
    const int wanted = place(row, column);
    while (at_ != end_ && place(at_->row, at_->last) < wanted) ++at_;
    const bool covers = at_ != end_ && at_->row == row && at_->first <= column;
    return covers ? at_->last : column - 1;
  }

 private:
  static constexpr int kRowStride = 256;  // more than the columns, which fit a byte
  static int place(int row, int column) { return kRowStride * row + column; }

  const Run* at_;
  const Run* end_;
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

// A lattice row: what is worked out once for its runs, of which bad light makes ten.
struct FeetRow {
  FeetRow(const Scene& scene, double v) : below(scene, v) {
    const auto depth = [&scene, v](double column) {
      return belowHorizon(scene, scene.frame.toImage({scene.lattice.u(column), v}));
    };
    constexpr double kFar = 64.0;
    depthAtStart = depth(0.0);
    depthPerColumn = (depth(kFar) - depthAtStart) / kFar;
  }

  // px from the horizon, of a run's middle
  double fromHorizon(const Run& run) const {
    return std::fabs(depthAtStart + depthPerColumn * 0.5 * (run.first + run.last));
  }

  WhiteBelow below;
  double depthAtStart = 0.0;  // below the horizon, of column 0
  double depthPerColumn = 0.0;
};

}  // namespace

BeaconFeet findBeaconFeet(const Scene& scene) {
  BeaconFeet feet;
  const double farthest = kMaxFromHorizon + rowSlack(scene);
  Undersides undersides(scene.runs);
  std::size_t first = 0;
  int row = -1;
  FeetRow here(scene, 0.0);
  for (const Run& run : scene.runs) {
    if (!isOfBand(run.colour)) continue;
    const double v = scene.lattice.v(run.row);
    if (run.row != row) {
      row = run.row;
      here = FeetRow(scene, v);
      first = firstNear(feet, first, v);
    }
    if (here.fromHorizon(run) > farthest) continue;
    for (int k = run.first; (k = undersides.next(run, k)) <= run.last; ++k)
      if (here.below.at(scene.sampler, k))
        addSample(feet, first, run.colour, scene.lattice.u(k), v);
  }
  return feet;
}

}  // namespace kelpie::vision
