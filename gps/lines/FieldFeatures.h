// SPDX-License-Identifier: Apache-2.0
// What is painted on the field, as straight pieces and a circle, and which of them is nearest to
// any place: a table of one byte a cell, so that the distance itself and its direction are exact
// and smooth. The foot of the border, ten pieces at most, is compared piece by piece. Beyond the
// table's margin the nearest cell counts. Wrong by up to half a cell where two pieces are equally
// near.
#pragma once

#include <array>
#include <cstdint>

#include "robot/body/FieldDescription.h"

namespace kelpie::gps {

// Signed distance (cm) to a piece and the unit vector along which it grows.
struct FeatureDistance {
  double value = 0.0;
  double alongX = 0.0;
  double alongY = 0.0;
};

class FieldFeatures {
 public:
  static constexpr std::size_t kMaxCells = 32768;

  // Builds the table, 20 M instructions on a PC: once, before the first frame.
  void build(const body::FieldDescription& field);
  bool built() const { return columns_ > 0; }

  // To the painted line that is nearest.
  FeatureDistance nearest(Point2<Field> p) const;
  // To the foot of the white border; far from everywhere on a field without one.
  FeatureDistance border(Point2<Field> p) const;
  // To the carpet: 0 on it.
  FeatureDistance outside(Point2<Field> p) const;

 private:
  struct Piece {
    Point2<Field> from;
    Point2<Field> along;  // unit vector; unused by the circle
    double length = 0.0;
    double radius = 0.0;  // of the circle, 0 for a straight piece
  };
  static Piece straightPiece(const body::FieldLine& line);
  static FeatureDistance distanceTo(const Piece& piece, Point2<Field> p);
  std::uint8_t nearestPiece(Point2<Field> p) const;
  std::size_t cellOf(Point2<Field> p) const;

  FixedVector<Piece, 25> pieces_;
  FixedVector<Piece, body::Border::kCapacity> border_;
  body::Carpet carpet_;
  double cell_ = 4.0;  // cm
  int columns_ = 0;
  int rows_ = 0;
  std::array<std::uint8_t, kMaxCells> table_{};
};

}  // namespace kelpie::gps
