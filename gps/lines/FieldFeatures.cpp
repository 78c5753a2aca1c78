// SPDX-License-Identifier: Apache-2.0
#include "gps/lines/FieldFeatures.h"

#include <algorithm>
#include <cmath>

namespace kelpie::gps {
namespace {

constexpr double kMargin = 100.0;  // cm of table around the lines
constexpr double kSmallestCell = 4.0;
constexpr double kNowhere = 1e6;  // cm

int cellsAlong(double length, double cell) {
  return static_cast<int>((length + 2.0 * kMargin) / cell) + 1;
}

}  // namespace

void FieldFeatures::build(const body::FieldDescription& field) {
  pieces_.clear();
  for (const body::FieldLine& line : field.lines)
    if (distance(line.start, line.end) > 0.0) pieces_.push_back(straightPiece(line));
  border_.clear();
  for (const body::BorderPiece& piece : body::borderOf(field))
    if (distance(piece.foot.start, piece.foot.end) > 0.0)
      border_.push_back(straightPiece(piece.foot));
  const double radius = 0.5 * (field.circleDiameter - field.lineWidth);
  if (radius > 0.0) pieces_.push_back({{field.width / 2, field.length / 2}, {}, 0.0, radius});
  carpet_ = body::carpetOf(field);
  cell_ = kSmallestCell;
  while (cellsAlong(field.width, cell_) * cellsAlong(field.length, cell_) >
         static_cast<int>(kMaxCells))
    cell_ *= 1.25;
  columns_ = cellsAlong(field.width, cell_);
  rows_ = cellsAlong(field.length, cell_);
  for (int j = 0; j < rows_; ++j)
    for (int i = 0; i < columns_; ++i) {
      const Point2<Field> middle{(i + 0.5) * cell_ - kMargin, (j + 0.5) * cell_ - kMargin};
      table_[static_cast<std::size_t>(j * columns_ + i)] = nearestPiece(middle);
    }
}

FieldFeatures::Piece FieldFeatures::straightPiece(const body::FieldLine& line) {
  const Point2<Field> way = line.end - line.start;
  const double length = way.norm();
  return {line.start, way * (1.0 / length), length, 0.0};
}

std::uint8_t FieldFeatures::nearestPiece(Point2<Field> p) const {
  std::size_t best = 0;
  double min = 1e9;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const double here = std::fabs(distanceTo(pieces_[i], p).value);
    if (here < min) {
      min = here;
      best = i;
    }
  }
  return static_cast<std::uint8_t>(best);
}

std::size_t FieldFeatures::cellOf(Point2<Field> p) const {
  // The conversion of a far place stays in range, and NaN becomes 0.
  const auto step = [this](double along, int count) {
    const double at = (along + kMargin) / cell_;
    return at > 0.0 ? static_cast<int>(std::min(at, count - 0.5)) : 0;
  };
  return static_cast<std::size_t>(step(p.y, rows_) * columns_ + step(p.x, columns_));
}

// Beyond a straight piece's end the distance is that to the end.
FeatureDistance FieldFeatures::distanceTo(const Piece& piece, Point2<Field> p) {
  Point2<Field> v = p - piece.from;
  if (piece.radius == 0.0) {
    const double way = v.x * piece.along.x + v.y * piece.along.y;
    if (way >= 0.0 && way <= piece.length)
      return {piece.along.x * v.y - piece.along.y * v.x, -piece.along.y, piece.along.x};
    v = v - piece.along * maths::clamp(way, 0.0, piece.length);
  }
  const double far = std::sqrt(v.x * v.x + v.y * v.y);
  if (far < 1e-9) return {-piece.radius, 0.0, 0.0};
  return {far - piece.radius, v.x / far, v.y / far};
}

FeatureDistance FieldFeatures::nearest(Point2<Field> p) const {
  if (pieces_.empty()) return {};
  return distanceTo(pieces_[table_[cellOf(p)]], p);
}

FeatureDistance FieldFeatures::border(Point2<Field> p) const {
  FeatureDistance best{kNowhere, 0.0, 0.0};
  for (const Piece& piece : border_) {
    const FeatureDistance here = distanceTo(piece, p);
    if (std::fabs(here.value) < std::fabs(best.value)) best = here;
  }
  return best;
}

FeatureDistance FieldFeatures::outside(Point2<Field> p) const {
  const Point2<Field> way = p - carpet_.nearest(p);
  const double far = way.norm();
  if (far < 1e-9) return {};
  return {far, way.x / far, way.y / far};
}

}  // namespace kelpie::gps
