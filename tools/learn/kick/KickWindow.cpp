// SPDX-License-Identifier: Apache-2.0
// The sums of a kick map: of the runs at one place, and of the places about the best one.
#include <algorithm>
#include <cmath>

#include "tools/learn/kick/KickMapLearning.h"

namespace kelpie::learn {
namespace {

constexpr double kSure = 0.8;     // share of balls that go, at every place of a window
constexpr double kAlike = 15.0;   // deg between the ways from a window's places and its best
constexpr double kFar = 200.0;    // cm that count as whole
constexpr double kWildSd = 30.0;  // deg of direction that have no utility

struct Sums {
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  void add(double value) {
    count += 1.0;
    sum += value;
    squares += value * value;
  }
  double mean() const { return count > 0.0 ? sum / count : 0.0; }
  double variance() const {
    return count > 0.0 ? std::fmax(0.0, squares / count - maths::square(mean())) : 0.0;
  }
};

double utilityOf(const KickCell& cell) {
  const double straight = std::fmax(0.0, 1.0 - cell.directionSd.deg() / kWildSd);
  return cell.went * straight * std::fmin(1.0, cell.distance / kFar) - cell.fell;
}

// A ball is never quite where it is thought to be: neighbours count half as much each.
double utilityAbout(const KickGrid& grid, std::size_t row, std::size_t column) {
  double sum = utilityOf(grid.cell(row, column));
  double weights = 1.0;
  for (int r = -1; r <= 1; ++r)
    for (int c = -1; c <= 1; ++c) {
      if (r == 0 && c == 0) continue;
      weights += 0.5;
      // The places left out of a kick that is its own mirror image.
      const auto otherColumn = static_cast<std::size_t>(isItsOwnMirror(grid.motion)
                                                            ? std::abs(static_cast<int>(column) + c)
                                                            : static_cast<int>(column) + c);
      const auto otherRow = row + static_cast<std::size_t>(r);
      if (otherRow < grid.ahead.size() && otherColumn < grid.lateral.size())
        sum += 0.5 * utilityOf(grid.cell(otherRow, otherColumn));
    }
  return sum / weights;
}

struct Block {
  std::size_t row = 0;
  std::size_t column = 0;
  std::size_t lastRow = 0;
  std::size_t lastColumn = 0;
};

template <class Each>
void eachCell(const KickGrid& grid, const Block& block, Each each) {
  for (std::size_t row = block.row; row <= block.lastRow; ++row)
    for (std::size_t column = block.column; column <= block.lastColumn; ++column)
      each(grid.cell(row, column));
}

bool isSure(const KickGrid& grid, const Block& block, const KickCell& best) {
  bool sure = true;
  eachCell(grid, block, [&](const KickCell& cell) {
    sure = sure && cell.runs > 0 && cell.went >= kSure &&
           std::fabs((cell.direction - best.direction).deg()) <= kAlike;
  });
  return sure;
}

// The places to the left, which a kick that is its own mirror image leaves out.
bool hasMirrorImage(const KickGrid& grid, const Block& block) {
  return isItsOwnMirror(grid.motion) && grid.from != KickFrom::hold &&
         grid.lateral[block.column] == 0.0;
}

std::size_t sizeOf(const KickGrid& grid, const Block& block) {
  const std::size_t columns = block.lastColumn - block.column + 1;
  return (block.lastRow - block.row + 1) *
         (hasMirrorImage(grid, block) ? 2 * columns - 1 : columns);
}

// The greatest one that has the best place in it; that place alone if nothing is sure.
Block sureBlock(const KickGrid& grid, std::size_t row, std::size_t column) {
  const KickCell& best = grid.cell(row, column);
  Block greatest{row, column, row, column};
  Block block;
  for (block.row = 0; block.row <= row; ++block.row)
    for (block.lastRow = row; block.lastRow < grid.ahead.size(); ++block.lastRow)
      for (block.column = 0; block.column <= column; ++block.column)
        for (block.lastColumn = column; block.lastColumn < grid.lateral.size(); ++block.lastColumn)
          if (sizeOf(grid, block) > sizeOf(grid, greatest) && isSure(grid, block, best))
            greatest = block;
  return greatest;
}

// Of several cells that are alike: their spreads and the spread between them.
KickCell together(const KickGrid& grid, const Block& block, const KickCell& best) {
  KickCell whole;
  Sums went;
  Sums fell;
  Sums distance;
  Sums direction;
  double distanceVariance = 0.0;
  double directionVariance = 0.0;
  const auto add = [&](const KickCell& cell, double side) {
    whole.runs += cell.runs;
    went.add(cell.went);
    fell.add(cell.fell);
    distance.add(cell.distance);
    direction.add(side * (cell.direction - best.direction).rad());
    distanceVariance += maths::square(cell.distanceSd);
    directionVariance += maths::square(cell.directionSd.rad());
  };
  eachCell(grid, block, [&](const KickCell& cell) { add(cell, 1.0); });
  if (hasMirrorImage(grid, block))
    eachCell(grid, {block.row, 1, block.lastRow, block.lastColumn},
             [&](const KickCell& cell) { add(cell, -1.0); });
  whole.went = went.mean();
  whole.fell = fell.mean();
  whole.distance = distance.mean();
  whole.distanceSd = std::sqrt(distance.variance() + distanceVariance / distance.count);
  whole.direction = best.direction + Angle::rad(direction.mean());
  whole.directionSd =
      Angle::rad(std::sqrt(direction.variance() + directionVariance / direction.count));
  return whole;
}

}  // namespace

KickCell cellOf(const std::vector<KickRun>& runs) {
  KickCell cell;
  Sums went;
  Sums fell;
  Sums distance;
  Point2<Robot> ways;
  for (const KickRun& run : runs) {
    if (!run.counts) continue;
    ++cell.runs;
    const bool goes = run.kicked.distance > kBallGoes;
    went.add(goes ? 1.0 : 0.0);
    fell.add(run.kicked.fell ? 1.0 : 0.0);
    if (!goes) continue;
    distance.add(run.kicked.distance);
    ways = ways + Point2<Robot>{run.kicked.direction.cos(), run.kicked.direction.sin()};
  }
  cell.went = went.mean();
  cell.fell = fell.mean();
  cell.distance = distance.mean();
  cell.distanceSd = std::sqrt(distance.variance());
  cell.direction = Angle::rad(maths::atan2(ways.y, ways.x));
  Sums off;
  for (const KickRun& run : runs)
    if (run.counts && run.kicked.distance > kBallGoes)
      off.add((run.kicked.direction - cell.direction).rad());
  cell.directionSd = Angle::rad(std::sqrt(off.variance() + maths::square(off.mean())));
  return cell;
}

KickWindow windowOf(const KickGrid& grid) {
  std::size_t best = 0;
  double utility = -1e9;
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    const double here = utilityAbout(grid, i / grid.lateral.size(), i % grid.lateral.size());
    if (here <= utility) continue;
    utility = here;
    best = i;
  }
  const std::size_t row = best / grid.lateral.size();
  const std::size_t column = best % grid.lateral.size();
  const Block block = sureBlock(grid, row, column);
  const double left =
      hasMirrorImage(grid, block) ? -grid.lateral[block.lastColumn] : grid.lateral[block.column];
  return {{grid.lateral[column], grid.ahead[row]},
          {left, grid.ahead[block.row]},
          {grid.lateral[block.lastColumn], grid.ahead[block.lastRow]},
          together(grid, block, grid.cell(row, column))};
}

}  // namespace kelpie::learn
