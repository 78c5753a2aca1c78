// SPDX-License-Identifier: Apache-2.0
// A goal is looked through column by column of its mouth: what shows of them tells its ends, the
// gaps between robots, and how well its middle is known.
#include <algorithm>
#include <array>
#include <cmath>

#include "robot/body/Camera.h"
#include "tools/percepts/Eye.h"
#include "tools/percepts/Shown.h"

namespace kelpie::percepts {
namespace {

constexpr double kSteepest = 80.0;       // deg, of the line of sight from square to the mouth
constexpr double kMinGap = 2.5;          // px
constexpr double kHeadingSd = 1.0;       // deg, as vision says of it
constexpr double kDistanceShare = 0.05;  // so
constexpr double kAlongByTurnSd = 4.0;   // cm, so

bool isGoal(LandmarkKind kind) { return kind <= LandmarkKind::goalYellow; }

// From its left to its right, as it is seen from the field.
Point2<Field> placeOf(const body::FieldDescription& field, Point2<Field> middle, double share) {
  const double side = middle.y > 0.5 * field.length ? 1.0 : -1.0;
  return {middle.x + side * field.goalWidth * (share - 0.5), middle.y};
}

bool facesField(const View& view, const body::FieldDescription& field, Point2<Field> middle) {
  const double outwards = middle.y > 0.5 * field.length ? 1.0 : -1.0;
  const double dx = middle.x - view.eye().position.x;
  const double dy = outwards * (middle.y - view.eye().position.y);
  return dy > 0.0 && std::atan2(std::fabs(dx), dy) < Angle::deg(kSteepest).rad();
}

// Both posts and the middle are far to one side of the image, or behind it.
bool isBeside(const View& view, const body::FieldDescription& field, Point2<Field> middle) {
  int left = 0, right = 0, behind = 0;
  for (const double share : {0.0, 0.5, 1.0}) {
    const Point2<Field> at = placeOf(field, middle, share);
    const auto spot = view.spot({at.x, at.y, 0.5 * field.goalHeight});
    behind += spot ? 0 : 1;
    left += spot && spot->pixel.x < 0.0 ? 1 : 0;
    right += spot && spot->pixel.x > kImageWidth ? 1 : 0;
  }
  return behind == 3 || left == 3 || right == 3;
}

MouthColumn columnAt(const View& view, double height, Point2<Field> at) {
  constexpr std::array<double, 4> kHeights{0.15, 0.4, 0.65, 0.9};  // of the goal's
  int inside = 0, free = 0;
  for (const double share : kHeights) {
    const auto spot = view.spot({at.x, at.y, share * height});
    if (!spot || !usable(spot->pixel)) continue;
    ++inside;
    free += view.hidden(*spot) ? 0 : 1;
  }
  if (inside < 2) return MouthColumn::outside;
  return 2 * free >= inside + (inside > 2 ? 1 : 0) ? MouthColumn::free : MouthColumn::hidden;
}

// Where a column is read to be, with an error of its own.
Point2<Robot> readColumn(const Look& look, const ShownMouth& mouth, std::size_t i) {
  PixelPoint pixel = mouth.pixel[i];
  pixel.x += look.random.gaussian(0.0, look.noise.goal.pixel);
  return readPlace(look.view.believed(), pixel, mouth.along[i]);
}

void addGaps(const Look& look, LandmarkKind kind, const ShownMouth& mouth, Percepts& percepts) {
  for (std::size_t i = 0; i < kMouthColumns; ++i) {
    if (mouth.column[i] != MouthColumn::free) continue;
    const std::size_t first = i;
    while (i + 1 < kMouthColumns && mouth.column[i + 1] == MouthColumn::free) ++i;
    if (std::fabs(mouth.pixel[i].x - mouth.pixel[first].x) < kMinGap) continue;
    GoalGap gap;
    gap.goal = kind;
    gap.left = bearing(readColumn(look, mouth, first));
    gap.right = bearing(readColumn(look, mouth, i));
    gap.leftCut = first > 0 && mouth.column[first - 1] == MouthColumn::outside;
    gap.rightCut = i + 1 < kMouthColumns && mouth.column[i + 1] == MouthColumn::outside;
    gap.box = {mouth.pixel[first].x, mouth.pixel[first].y, mouth.pixel[i].x, mouth.pixel[i].y};
    percepts.gaps.push_back(gap);
  }
}

// cm by which its middle is uncertain because of what does not show.
double hiddenSd(const Look& look, bool leftOpen, bool rightOpen, double shown, double oneEnd) {
  if (!leftOpen && !rightOpen) return 0.0;
  const double hidden = (1.0 - shown) * look.field.goalWidth;
  return (leftOpen && rightOpen ? 1.6 : 1.0) * oneEnd * hidden;
}

PixelBox boxOf(const Look& look, const ShownMouth& mouth) {
  const double half = 0.5 * look.view.eye().lens.focal * look.field.goalHeight /
                      std::max(20.0, 0.5 * (mouth.along[mouth.first] + mouth.along[mouth.last]));
  const PixelPoint a = mouth.pixel[mouth.first], b = mouth.pixel[mouth.last];
  return {std::min(a.x, b.x), std::min(a.y, b.y) - half, std::max(a.x, b.x),
          std::max(a.y, b.y) + half};
}

void add(const Look& look, const body::Landmark& mark, const ShownMouth& mouth,
         Percepts& percepts) {
  const GoalErrors& errors = look.noise.goal;
  const CameraPose& camera = look.view.believed();
  const auto middle =
      look.view.spot({mark.position.x, mark.position.y, 0.5 * look.field.goalHeight});
  if (!middle) return;
  const double along = look.view.distance(mark.position);
  const bool leftOpen = mouth.first > 0, rightOpen = mouth.last + 1 < kMouthColumns;
  const double across = look.random.gaussian(
      0.0, hiddenSd(look, leftOpen, rightOpen, mouth.share, errors.hiddenShare));
  PixelPoint pixel = middle->pixel;
  pixel.x +=
      look.random.gaussian(0.0, errors.pixel) + across * look.view.eye().lens.focal / middle->depth;
  const double seenAlong = along * look.random.gaussian(1.0, errors.share);
  const Point2<Robot> place = readPlace(camera, pixel, seenAlong);
  LandmarkPercept p;
  p.kind = mark.kind;
  p.distance = place.norm();
  p.heading = bearing(place);
  p.elevation = Angle::rad(maths::atan(readSlope(camera, pixel)));
  const double unsure = hiddenSd(look, leftOpen, rightOpen, mouth.share, 0.25);
  p.distanceVariance = maths::square(0.03 * p.distance) +
                       maths::square(kDistanceShare * p.distance) + unsure * unsure;
  p.headingVariance = maths::square(Angle::deg(kHeadingSd).rad()) +
                      maths::square(std::max(unsure, kAlongByTurnSd) / std::max(p.distance, 20.0));
  p.leftEdge = bearing(readColumn(look, mouth, mouth.first));
  p.rightEdge = bearing(readColumn(look, mouth, mouth.last));
  p.leftEdgeCut = leftOpen;
  p.rightEdgeCut = rightOpen;
  p.box = boxOf(look, mouth);
  percepts.landmarks.push_back(p);
}

}  // namespace

ShownMouth shownMouth(const View& view, const body::FieldDescription& field, Point2<Field> middle) {
  ShownMouth mouth;
  mouth.column.fill(MouthColumn::outside);
  if (!facesField(view, field, middle) || isBeside(view, field, middle)) return mouth;
  for (std::size_t i = 0; i < kMouthColumns; ++i) {
    const Point2<Field> at = placeOf(field, middle, static_cast<double>(i) / (kMouthColumns - 1));
    const auto spot = view.spot({at.x, at.y, 0.5 * field.goalHeight});
    if (!spot) continue;
    mouth.pixel[i] = spot->pixel;
    mouth.along[i] = view.distance(at);
    mouth.column[i] = columnAt(view, field.goalHeight, at);
    if (mouth.column[i] != MouthColumn::free) continue;
    mouth.first = std::min(mouth.first, i);
    mouth.last = i;
    mouth.share += 1.0 / kMouthColumns;
  }
  return mouth;
}

void seeGoals(const Look& look, Percepts& percepts) {
  const GoalErrors& errors = look.noise.goal;
  for (const body::Landmark& mark : look.field.landmarks) {
    if (!isGoal(mark.kind) || look.view.distance(mark.position) > errors.farthest) continue;
    const ShownMouth mouth = shownMouth(look.view, look.field, mark.position);
    const bool near = look.view.distance(mark.position) < errors.near;
    const double recall = recallOf(errors.recall, mouth.share) * (near ? errors.nearRecall : 1.0);
    if (!look.random.chance(recall)) continue;
    add(look, mark, mouth, percepts);
    addGaps(look, mark.kind, mouth, percepts);
  }
}

}  // namespace kelpie::percepts
