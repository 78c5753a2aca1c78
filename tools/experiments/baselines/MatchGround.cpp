// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/baselines/MatchGround.h"

#include <algorithm>
#include <cmath>

namespace kelpie::gps {
namespace {

double toPiece(const body::FieldLine& piece, Point2<Field> p) {
  const Point2<Field> way = piece.end - piece.start;
  const Point2<Field> from = p - piece.start;
  const double length2 = way.x * way.x + way.y * way.y;
  if (!(length2 > 0.0)) return from.norm();
  const double share = maths::clamp((from.x * way.x + from.y * way.y) / length2, 0.0, 1.0);
  return distance(p, piece.start + way * share);
}

body::Carpet widened(const body::Carpet& carpet, double by) {
  return {carpet.low - Point2<Field>{by, by}, carpet.high + Point2<Field>{by, by}};
}

bool contains(const body::Carpet& carpet, Point2<Field> p) {
  return distance(p, carpet.nearest(p)) == 0.0;
}

}  // namespace

// The slope is as wide as it is high; its upper edge in a corner is parallel to its foot, that
// width farther out.
MatchGround::MatchGround(const body::FieldDescription& field, const FieldFeatures& features,
                         double outside)
    : field_(field),
      features_(features),
      hasWall_(outside > 0.0),
      wall_(widened(body::carpetOf(field), outside)),
      foot_{field.borderWidth, field.borderCorner},
      top_{0.0, std::max(0.0, field.borderCorner + (2.0 - std::sqrt(2.0)) * field.borderWidth)} {}

double MatchGround::toLine(Point2<Field> p) const { return std::fabs(features_.nearest(p).value); }

double MatchGround::toBorder(Point2<Field> p) const {
  const double own = std::fabs(features_.border(p).value);
  return hasWall_ ? std::min(own, toWall(p)) : own;
}

double MatchGround::toGreen(Point2<Field> p) const {
  if (!(field_.borderWidth > 0.0)) return distance(p, wall_.nearest(p));
  const double inner = isInside(foot_, p) ? 0.0 : toOutline(foot_, p);
  if (!hasWall_) return inner;
  if (!contains(wall_, p)) return distance(p, wall_.nearest(p));
  return isInside(top_, p) ? std::min(inner, toOutline(top_, p)) : 0.0;
}

// All four quarters of the field are alike.
Point2<Field> MatchGround::inFirstQuarter(Point2<Field> p) const {
  return {std::min(p.x, field_.width - p.x), std::min(p.y, field_.length - p.y)};
}

bool MatchGround::isInside(const Outline& outline, Point2<Field> p) const {
  const Point2<Field> q = inFirstQuarter(p);
  return q.x >= outline.inset && q.y >= outline.inset &&
         q.x + q.y >= 2.0 * outline.inset + outline.corner;
}

double MatchGround::toOutline(const Outline& outline, Point2<Field> p) const {
  const Point2<Field> q = inFirstQuarter(p);
  const double low = outline.inset;
  const double high = outline.inset + outline.corner;
  const double side = toPiece({{low, high}, {low, 0.5 * field_.length}}, q);
  const double end = toPiece({{high, low}, {0.5 * field_.width, low}}, q);
  return std::min({side, end, toPiece({{low, high}, {high, low}}, q)});
}

double MatchGround::toWall(Point2<Field> p) const {
  if (!contains(wall_, p)) return distance(p, wall_.nearest(p));
  return std::min({p.x - wall_.low.x, wall_.high.x - p.x, p.y - wall_.low.y, wall_.high.y - p.y});
}

}  // namespace kelpie::gps
