// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/baselines/MatchTable.h"

#include <algorithm>
#include <cmath>

namespace kelpie::gps {
namespace {

struct Group {
  double weight = 0.0;
  double value = 0.0;
  Vector3 slope = Vector3::Zero();
};

template <typename Points, typename TableOf>
Group summed(const Points& points, const Pose2& pose, const TableOf& tableOf,
             Interpolation interpolation) {
  Group group;
  const double s = pose.heading.sin();
  const double c = pose.heading.cos();
  for (const SeenPoint& point : points) {
    const MatchValue m = tableOf(point).at(fieldFromRobot(pose, point.place), interpolation);
    const double spin = m.slopeX * (c * point.place.x - s * point.place.y) +
                        m.slopeY * (s * point.place.x + c * point.place.y);
    group.weight += point.weight;
    group.value += point.weight * m.value;
    group.slope += point.weight * Vector3(m.slopeX, m.slopeY, spin);
  }
  return group;
}

// A kind that was not seen says nothing.
OverallMatch meanOf(const Group& group) {
  if (!(group.weight > 0.0)) return {1.0, Vector3::Zero()};
  return {group.value / group.weight, group.slope / group.weight};
}

}  // namespace

double matchAt(double distance, const MatchOptions& options) {
  const double fall = options.sharpness * distance * distance;
  return options.decay == MatchDecay::bell ? std::exp(-fall) : 1.0 / (1.0 + fall);
}

double MatchTable::cell(int column, int row) const {
  const int i = std::clamp(column, 0, columns_ - 1);
  const int j = std::clamp(row, 0, rows_ - 1);
  return static_cast<double>(values_[static_cast<std::size_t>(j * columns_ + i)]);
}

MatchValue MatchTable::at(Point2<Field> p, Interpolation interpolation) const {
  const double x = maths::clamp((p.x + kMargin) / kCell, 0.0, columns_ - 1.0);
  const double y = maths::clamp((p.y + kMargin) / kCell, 0.0, rows_ - 1.0);
  return interpolation == Interpolation::thesis ? thesis(x, y) : bilinear(x, y);
}

// Thesis 2004 equations 3.4 to 3.10: the value is linear towards the nearer neighbours, the slope
// that of a parabola through three cells.
MatchValue MatchTable::thesis(double x, double y) const {
  const int i = static_cast<int>(x + 0.5);
  const int j = static_cast<int>(y + 0.5);
  const double u = x - i;
  const double v = y - j;
  const double here = cell(i, j);
  const double left = cell(i - 1, j);
  const double right = cell(i + 1, j);
  const double below = cell(i, j - 1);
  const double above = cell(i, j + 1);
  MatchValue m;
  m.value = here + std::fabs(u) * ((u > 0.0 ? right : left) - here) +
            std::fabs(v) * ((v > 0.0 ? above : below) - here);
  m.slopeX = ((u + 0.5) * (right - here) + (u - 0.5) * (left - here)) / kCell;
  m.slopeY = ((v + 0.5) * (above - here) + (v - 0.5) * (below - here)) / kCell;
  return m;
}

MatchValue MatchTable::bilinear(double x, double y) const {
  const int i = static_cast<int>(x);
  const int j = static_cast<int>(y);
  const double u = x - i;
  const double v = y - j;
  const double low = cell(i, j) + u * (cell(i + 1, j) - cell(i, j));
  const double high = cell(i, j + 1) + u * (cell(i + 1, j + 1) - cell(i, j + 1));
  const double across =
      (1.0 - v) * (cell(i + 1, j) - cell(i, j)) + v * (cell(i + 1, j + 1) - cell(i, j + 1));
  return {low + v * (high - low), across / kCell, (high - low) / kCell};
}

MatchTables::MatchTables(const body::FieldDescription& field, const FieldFeatures& features,
                         const MatchOptions& options)
    : MatchTables(MatchGround(field, features, options.outside), field, options) {}

MatchTables::MatchTables(const MatchGround& ground, const body::FieldDescription& field,
                         const MatchOptions& options)
    : lines(field, options, [&ground](Point2<Field> p) { return ground.toLine(p); }),
      border(field, options, [&ground](Point2<Field> p) { return ground.toBorder(p); }),
      carpet(field, options, [&ground](Point2<Field> p) { return ground.toGreen(p); }) {}

OverallMatch overallMatch(const SeenLines& seen, const Pose2& pose, const MatchTables& tables,
                          Interpolation interpolation) {
  const auto whiteTable = [&tables](const SeenPoint& point) -> const MatchTable& {
    return point.border ? tables.border : tables.lines;
  };
  const auto carpetTable = [&tables](const SeenPoint&) -> const MatchTable& {
    return tables.carpet;
  };
  const OverallMatch lines = meanOf(summed(seen.lines, pose, whiteTable, interpolation));
  const OverallMatch carpet = meanOf(summed(seen.carpet, pose, carpetTable, interpolation));
  return {lines.value * carpet.value, lines.slope * carpet.value + lines.value * carpet.slope};
}

Ascent ascend(const SeenLines& seen, const Pose2& start, const MatchTables& tables,
              const AscentParams& params) {
  OverallMatch here = overallMatch(seen, start, tables, Interpolation::thesis);
  Ascent ascent{start, here.value, 1};
  double rate = params.rate;
  for (; ascent.steps < params.maxSteps && rate > params.exitRate; ++ascent.steps) {
    const Pose2 next{{ascent.pose.position.x + rate * here.slope(0),
                      ascent.pose.position.y + rate * here.slope(1)},
                     ascent.pose.heading + Angle::rad(rate * params.headingScale * here.slope(2))};
    const OverallMatch there = overallMatch(seen, next, tables, Interpolation::thesis);
    if (there.value < ascent.match) {
      rate *= 0.5;
      continue;
    }
    rate *= 1.2;
    here = there;
    ascent.pose = next;
    ascent.match = there.value;
  }
  return ascent;
}

}  // namespace kelpie::gps
