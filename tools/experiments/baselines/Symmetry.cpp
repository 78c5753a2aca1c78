// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/baselines/Symmetry.h"

#include <algorithm>
#include <cmath>

#include "gps/SamePose.h"

namespace kelpie::gps {
namespace {

constexpr double kJoinDistance = 3.0;  // cm: ends of lines that near meet
constexpr double kRightAngle = 0.5 * maths::kPi;

// Directions in which paint leaves a place.
using Arms = FixedVector<Angle, 8>;

void addArm(Angle arm, Arms& arms) {
  for (const Angle other : arms)
    if ((other - arm).abs().deg() < 10.0) return;
  arms.push_back(arm);
}

Arms armsAt(Point2<Field> place, const body::FieldDescription& field) {
  Arms arms;
  for (const body::FieldLine& line : field.lines) {
    const Point2<Field> way = line.end - line.start;
    const double length = way.norm();
    if (!(length > kJoinDistance)) continue;
    const Angle along = Angle::rad(maths::atan2(way.y, way.x));
    const Point2<Field> d = place - line.start;
    const double at = (d.x * way.x + d.y * way.y) / length;
    const double lateral = std::fabs(d.x * way.y - d.y * way.x) / length;
    if (lateral > kJoinDistance || at < -kJoinDistance || at > length + kJoinDistance) continue;
    if (at < length - kJoinDistance) addArm(along, arms);
    if (at > kJoinDistance) addArm(along + Angle::rad(maths::kPi), arms);
  }
  return arms;
}

bool known(const PaintedFeatures& all, Point2<Field> place) {
  for (const PaintedFeature& f : all)
    if (distance(f.place, place) < kJoinDistance) return true;
  return false;
}

bool isRight(Angle a, Angle b) { return std::fabs((a - b).abs().rad() - kRightAngle) < 0.1; }

Angle between(Angle a, Angle b) { return a + (b - a) * 0.5; }

// Pairs of perpendicular arms are corners; of three arms the one square to the other two is a stem.
void addCrossing(Point2<Field> place, const Arms& arms, PaintedFeatures& all) {
  for (std::size_t i = 0; i < arms.size(); ++i) {
    std::size_t square = 0;
    for (std::size_t j = 0; j < arms.size(); ++j) {
      if (i == j || !isRight(arms[i], arms[j])) continue;
      ++square;
      if (j > i) all.push_back({FeatureKind::corner, place, between(arms[i], arms[j]), 0.0});
    }
    if (arms.size() == 3 && square == 2) all.push_back({FeatureKind::tee, place, arms[i], 0.0});
  }
}

void addStraight(const body::FieldLine& line, PaintedFeatures& all) {
  const Point2<Field> way = line.end - line.start;
  const double length = way.norm();
  if (!(length > kJoinDistance)) return;
  const Point2<Field> middle = line.start + way * 0.5;
  const Angle normal = Angle::rad(maths::atan2(way.y, way.x) + kRightAngle);
  all.push_back({FeatureKind::straight, middle, normal, 0.5 * length});
  all.push_back({FeatureKind::straight, middle, normal + Angle::rad(maths::kPi), 0.5 * length});
}

bool isStraight(const PaintedFeature& feature) {
  return feature.kind == FeatureKind::straight || feature.kind == FeatureKind::border;
}

// The normal is the one that points to the side of the field's middle.
void addBorder(const body::FieldLine& foot, Point2<Field> centre, PaintedFeatures& all) {
  const Point2<Field> way = foot.end - foot.start;
  const double length = way.norm();
  if (!(length > kJoinDistance)) return;
  const Point2<Field> middle = foot.start + way * 0.5;
  const Point2<Field> inwards = centre - middle;
  const double side = way.x * inwards.y - way.y * inwards.x < 0.0 ? -kRightAngle : kRightAngle;
  const Angle normal = Angle::rad(maths::atan2(way.y, way.x) + side);
  all.push_back({FeatureKind::border, middle, normal, 0.5 * length});
}

// Where two pieces of the border's foot meet, each of them leaves that place along its own arm.
void addBend(const body::FieldLine& one, const body::FieldLine& other, PaintedFeatures& all) {
  for (const bool oneEnds : {false, true})
    for (const bool otherEnds : {false, true}) {
      const Point2<Field> place = oneEnds ? one.end : one.start;
      if (distance(place, otherEnds ? other.end : other.start) > kJoinDistance) continue;
      const Point2<Field> along = (oneEnds ? one.start : one.end) - place;
      const Point2<Field> beside = (otherEnds ? other.start : other.end) - place;
      all.push_back({FeatureKind::borderBend, place,
                     between(Angle::rad(maths::atan2(along.y, along.x)),
                             Angle::rad(maths::atan2(beside.y, beside.x))),
                     0.0});
    }
}

void addBorderFeatures(const body::FieldDescription& field, PaintedFeatures& all) {
  const body::Border border = body::borderOf(field);
  for (std::size_t i = 0; i < border.size(); ++i) {
    addBorder(border[i].foot, {field.width / 2, field.length / 2}, all);
    for (std::size_t j = 0; j < i; ++j) addBend(border[i].foot, border[j].foot, all);
  }
}

// Keeps the best, sorted.
void keep(const AmbiguousPose& pose, std::size_t max, AmbiguousPoses& poses) {
  for (const AmbiguousPose& other : poses)
    if (samePose(other.pose, pose.pose, kSameCm, kSameDeg)) return;
  std::size_t at = poses.size();
  while (at > 0 && poses[at - 1].match < pose.match) --at;
  if (at >= max) return;
  if (poses.size() < max) poses.resize(poses.size() + 1);
  for (std::size_t i = poses.size() - 1; i > at; --i) poses[i] = poses[i - 1];
  poses[at] = pose;
}

SeenLines thinned(const SeenLines& seen, std::size_t max) {
  SeenLines few;
  few.carpet = seen.carpet;
  for (std::size_t i = 0; i < seen.lines.size(); ++i)
    if (isSpread(i, seen.lines.size(), max)) few.lines.push_back(seen.lines[i]);
  return few;
}

}  // namespace

PaintedFeatures paintedFeatures(const body::FieldDescription& field) {
  PaintedFeatures all;
  for (const body::FieldLine& line : field.lines)
    for (const Point2<Field> end : {line.start, line.end})
      if (!known(all, end)) addCrossing(end, armsAt(end, field), all);
  if (field.circleDiameter > 0.0)
    for (const double degrees : {0.0, 180.0})
      all.push_back(
          {FeatureKind::circle, {field.width / 2, field.length / 2}, Angle::deg(degrees), 0.0});
  for (const body::FieldLine& line : field.lines) addStraight(line, all);
  addBorderFeatures(field, all);
  return all;
}

Pose2 movedWithFeature(const Pose2& pose, const PaintedFeature& from, const PaintedFeature& to) {
  const Angle by = to.direction - from.direction;
  const Point2<Field> d = pose.position - from.place;
  const Point2<Field> around{by.cos() * d.x - by.sin() * d.y, by.sin() * d.x + by.cos() * d.y};
  return {to.place + around, pose.heading + by};
}

Matrix3 withoutAlong(const Matrix3& information, Angle direction) {
  const Vector3 along(direction.cos(), direction.sin(), 0.0);
  const Vector3 shared = information * along;
  const double own = along.dot(shared);
  if (!(own > 0.0)) return information;
  return information - shared * shared.transpose() / own;
}

Point2<Field> middlePoint(const SeenLines& seen, const Pose2& pose) {
  Point2<Robot> mean;
  for (const SeenPoint& p : seen.lines) mean = mean + p.place;
  if (!seen.lines.empty()) mean = mean * (1.0 / static_cast<double>(seen.lines.size()));
  Point2<Robot> nearest = mean;
  double min = 1e12;
  for (const SeenPoint& p : seen.lines) {
    const Point2<Robot> d = p.place - mean;
    const double away = d.x * d.x + d.y * d.y;
    if (away >= min) continue;
    min = away;
    nearest = p.place;
  }
  return fieldFromRobot(pose, nearest);
}

bool isInWindow(const PaintedFeature& feature, Point2<Field> point, const SymmetryParams& params) {
  const Point2<Field> d = point - feature.place;
  if (!isStraight(feature)) return d.norm() <= params.window;
  const double lateral = d.x * feature.direction.cos() + d.y * feature.direction.sin();
  const double along = d.y * feature.direction.cos() - d.x * feature.direction.sin();
  return std::fabs(lateral) <= params.window && std::fabs(along) <= feature.half - params.window;
}

AmbiguousPoses ambiguousPoses(const SeenLines& seen, const LineFit& fit, const PaintedField& field,
                              const PaintedFeatures& painted, const LineUpdateParams& lines,
                              const SymmetryParams& params) {
  AmbiguousPoses poses;
  const std::size_t max = std::min<std::size_t>(params.maxPoses, kMaxAmbiguousPoses);
  const Point2<Field> middle = middlePoint(seen, fit.pose);
  const SeenLines few = thinned(seen, params.points);
  keep({twinOf(fit.pose, field.description), fit.match, turned(fit.information, Angle::deg(180))},
       max, poses);
  for (const PaintedFeature& from : painted) {
    if (!isInWindow(from, middle, params)) continue;
    const Angle along = from.direction + Angle::deg(90);
    const Matrix3 known = isStraight(from) ? withoutAlong(fit.information, along) : fit.information;
    for (const PaintedFeature& to : painted) {
      if (to.kind != from.kind) continue;
      const Pose2 pose = movedWithFeature(fit.pose, from, to);
      const double match = lineMatch(few, pose, field.features, lines);
      if (match < lines.match) continue;
      keep({pose, match, turned(known, to.direction - from.direction)}, max, poses);
    }
  }
  return poses;
}

}  // namespace kelpie::gps
