// SPDX-License-Identifier: Apache-2.0
// The ground of which the match tables tell (thesis 2004 section 3.2.2): how far a place is from a
// painted line, from a border and from the green. On UNSW's field nothing beyond the border was
// seen. In Lisbon the ground up to an outer wall was as green as the field, so that the wall's foot
// is a second border and the green goes on behind the first. The goals are left out.
#pragma once

#include "gps/lines/FieldFeatures.h"

namespace kelpie::gps {

constexpr double kSeenAtHome = 0.0;  // cm of green beyond the border
// cm, the same in Lisbon: the thesis only says "a large amount"; taken is the gap
// between side line and outer wall of 2005 (facts-2005 section 1).
constexpr double kSeenInLisbon = 88.0;

class MatchGround {
 public:
  // `outside`: cm of green that are seen between the border, or the carpet's end, and an outer
  // wall.
  MatchGround(const body::FieldDescription& field, const FieldFeatures& features, double outside);

  // All in cm.
  double toLine(Point2<Field> p) const;
  double toBorder(Point2<Field> p) const;
  double toGreen(Point2<Field> p) const;
  // The corners of the outer wall's foot.
  const body::Carpet& wall() const { return wall_; }

 private:
  // The border's foot or its upper edge: a rectangle with its corners cut off at 45 deg.
  struct Outline {
    double inset = 0.0;   // cm, from the edges of the field
    double corner = 0.0;  // cm, legs of the triangles that are cut off
  };
  bool isInside(const Outline& outline, Point2<Field> p) const;
  double toOutline(const Outline& outline, Point2<Field> p) const;
  Point2<Field> inFirstQuarter(Point2<Field> p) const;
  double toWall(Point2<Field> p) const;

  const body::FieldDescription& field_;
  const FieldFeatures& features_;
  bool hasWall_;
  body::Carpet wall_;
  Outline foot_;
  Outline top_;
};

}  // namespace kelpie::gps
