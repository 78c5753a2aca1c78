// SPDX-License-Identifier: Apache-2.0
#include "vision/goal/GoalColumns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "robot/core/ScratchVector.h"
#include "vision/pixels/Between.h"
#include "vision/pixels/GroundRay.h"
#include "vision/pixels/SpanWalk.h"

namespace kelpie::vision {
namespace {

constexpr int kHoles = 2;
constexpr double kMinSpacing = 2.0;         // px between columns
constexpr double kMaxHeightRatio = 1.4;     // of a column's height to the goal's
constexpr double kDistanceTolerance = 0.2;  // share by which columns' distances may differ
constexpr double kFootSd = 0.012;           // rad, between a column's foot and the ground
constexpr double kFootRows = 2.5;           // px by which the feet of a goal's columns differ,
constexpr double kFootShare = 0.1;          // and so much of their height
// Ends are sought at this share of the wall's height above the foot, so this one below the top.
constexpr double kEndHeight = 0.25;
constexpr double kEndBelowTop = 0.75;

// The lowest pixel of the candidate's colour in a level column, two lattice steps of it in a row.
std::optional<PixelPoint> lowestIn(const Scene& scene, const GoalCandidate& c, double u) {
  const auto isColour = [&](PixelPoint p) {
    return Sampler::usable(p) && scene.sampler.classAt(p) == c.colour;
  };
  const auto at = [&](double v) { return scene.frame.toImage({u, v}); };
  // The upper one of two first: where it is not of the colour the lower one need not be asked.
  double v = c.box.bottom - 0.5 - kLatticeStep;
  while (v > c.box.top) {
    const PixelPoint upper = at(v);
    const bool here = isColour(upper);
    if (here && isColour(at(v + kLatticeStep))) return upper;
    v -= here ? kLatticeStep : 2 * kLatticeStep;
  }
  return std::nullopt;
}

// Of the rays through a column's foot and top.
struct Slopes {
  double low;
  double high;
};

// The image's top cuts it although a goal at the distance of its foot would end below that, or it
// ends in the image, but far too high for where its foot stands.
bool isTooTall(const Scene& scene, const GoalCandidate& c, bool topCut, const Slopes& at) {
  const CameraPose& camera = scene.body.camera;
  const auto [low, high] = at;
  constexpr double kMinSlope = 0.01;  // a foot at the horizon: no goal fills the view
  const double d = camera.position.z / std::max(c.doubt.slack() - low, kMinSlope);
  const double allowed = topCut ? kMaxHeightRatio : 2.0 * kMaxHeightRatio;
  return (high - low) * d > allowed * scene.field.goalHeight;
}

enum class Below { green, other, outside };

// Whether the carpet follows, within two pixels and a tenth of the height.
Below belowFoot(const Scene& scene, const EdgeHit& foot, double height) {
  constexpr double kNear = 1.5;  // px
  constexpr double kFar = 2.5;
  constexpr double kHeightShare = 0.1;
  if (foot.cut) return Below::outside;
  for (const double below : {kNear, kFar, kFar + kHeightShare * height}) {
    const PixelPoint at = moved(foot.point, scene.frame.up(), -below);
    if (!Sampler::usable(at)) return Below::outside;
    if (scene.sampler.classAt(at) == ColourClass::green) return Below::green;
  }
  return Below::other;
}

// Whether the ground tells how far away something is, as far as the tilt is known. At a robot's
// start it does up to 130 cm: beyond, goals by their feet were wrong by half of their distance.
bool groundTells(const GoalCandidate& c, double distance, double above) {
  constexpr double kMaxShare = 0.2;  // of the distance, sd
  return c.doubt.sd * distance <= kMaxShare * above;
}

// By height when both ends are in the image, else by the foot on the ground.
void measureDistance(const Scene& scene, const GoalFinderParams& p, const GoalCandidate& c,
                     const Slopes& at, GoalColumn& column) {
  constexpr double kMinSlopes = 1e-3;   // between foot and top
  constexpr double kMinDescent = 0.03;  // slope; a flatter ray's foot tells no distance
  const CameraPose& camera = scene.body.camera;
  const auto [low, high] = at;
  if (!column.topCut) {
    const double height = high - low - p.edgeBias / camera.lens.focalLength;
    const double d = scene.field.goalHeight / std::max(height, kMinSlopes);
    column.distance = d;
    column.sd = sizeSd(camera, d, scene.field.goalHeight, p.edgeSd);
    column.footError = maths::atan(low) - maths::atan(-camera.position.z / d);
  } else if (low < -kMinDescent && groundTells(c, -camera.position.z / low, camera.position.z)) {
    column.distance = -camera.position.z / low;
    const double direction = maths::hypot(p.directionSd.rad(), c.doubt.sd);
    column.sd = maths::square(column.distance) / camera.position.z * direction;
  }
}

double paintOf(const Scene& scene, const CarpetColour& carpet, const GoalCandidate& c,
               const GoalColumn& column) {
  constexpr std::array<double, 3> kShares{0.3, 0.5, 0.7};  // of the way to the top
  double sum = 0.0;
  for (const double share : kShares) {
    sum += paintShare(scene, carpet, c.colour, between(column.foot, column.top, share));
  }
  return sum / static_cast<double>(kShares.size());
}

// Upwards from a column's lowest pixel, where its colour ends or a paler one of the same class
// begins.
EdgeHit topOf(const Scene& scene, const CarpetColour& carpet, const GoalCandidate& c,
              PixelPoint start, PixelPoint foot) {
  const EdgeHit top = walkToEdge(scene.sampler, {start, scene.frame.up(), c.colour, kHoles});
  const auto share = paintedShare(scene, carpet, c.colour, foot, top.point);
  if (!share) return top;
  return {between(foot, top.point, *share), false, *share * top.length};
}

std::optional<GoalColumn> columnAt(const Scene& scene, const GoalFinderParams& p,
                                   const CarpetColour& carpet, GoalCandidate& c, double u) {
  const auto start = lowestIn(scene, c, u);
  if (!start) return std::nullopt;
  const ImageDirection up = scene.frame.up();
  const EdgeHit foot = walkToEdge(scene.sampler, {*start, -up, c.colour, kHoles});
  const EdgeHit top = topOf(scene, carpet, c, *start, foot.point);
  GoalColumn column;
  column.u = u;
  column.top = top.point;
  column.foot = foot.point;
  column.topCut = top.cut;
  column.paint = paintOf(scene, carpet, c, column);
  // Cut below, nothing speaks against carpet.
  const Below below = belowFoot(scene, foot, top.length + foot.length);
  column.footCut = below == Below::outside;
  column.green = below != Below::other;
  if (column.footCut) return column;
  const Slopes at{groundRayThrough(scene.body.camera, foot.point).slope,
                  groundRayThrough(scene.body.camera, top.point).slope};
  column.tall = isTooTall(scene, c, top.cut, at);
  measureDistance(scene, p, c, at, column);
  return column;
}

bool agrees(const GoalColumn& column, double distance) {
  return std::fabs(column.distance - distance) <= kDistanceTolerance * distance + column.sd;
}

// A robot's head before its top makes a column too short, so too far for where its foot stands.
bool isMeasured(const GoalCandidate& c, const GoalColumn& column, const GoalFinderParams& p) {
  return column.green && !column.tall && column.distance > 0.0 &&
         std::fabs(column.footError) <= p.directionError.rad() * c.doubt.spread;
}

// How much of a goal of this distance the columns are, a column less the worse its foot fits the
// ground there: clothes behind make it higher, so too near, a robot's head before it too short.
double supportOf(const GoalCandidate& c, const GoalColumn& reference, const GoalFinderParams& p) {
  double support = 0.0;
  const double footSd = kFootSd * c.doubt.spread;
  for (const GoalColumn& column : c.columns) {
    if (!isMeasured(c, column, p) || !agrees(column, reference.distance)) continue;
    support += 1.0 / (1.0 + maths::square(column.footError / footSd));
  }
  return support;
}

// The distance of the column with the largest support; 0 when no column is measured.
double likelyDistance(const GoalCandidate& c, const GoalFinderParams& p) {
  double best = 0.0;
  double max = 0.0;
  for (const GoalColumn& column : c.columns) {
    if (!isMeasured(c, column, p) || column.distance > p.maxDistance) continue;
    const double support = supportOf(c, column, p);
    if (support <= max) continue;
    max = support;
    best = column.distance;
  }
  return best;
}

double heightOf(const GoalColumn& column) {
  return maths::hypot(column.top.x - column.foot.x, column.top.y - column.foot.y);
}

double widthOf(const Scene& scene, const GoalCandidate& c, double distance) {
  double left = kFarOutside;
  double right = -kFarOutside;
  for (const GoalColumn& column : c.columns) {
    if (!column.chosen) continue;
    left = std::min(left, column.u);
    right = std::max(right, column.u);
  }
  return (right - left) * distance / focalLength(scene);
}

// A low strip of the goal's colour beside it has a foot in line with its own. Where a robot's head
// hides the top the columns are low too, so only columns of what is wider than a goal seen
// obliquely are dropped.
void dropLowEnds(const Scene& scene, double distance, GoalCandidate& c) {
  constexpr double kMaxWidth = 110.0;      // cm
  constexpr double kLowColumnShare = 0.7;  // of the goal's height
  if (widthOf(scene, c, distance) <= kMaxWidth) return;
  const double minHeight =
      kLowColumnShare * scene.field.goalHeight * focalLength(scene) / std::max(distance, 1.0);
  const auto isLow = [minHeight](const GoalColumn& column) {
    return column.chosen && column.distance <= 0.0 && !column.topCut && !column.footCut &&
           heightOf(column) < minHeight;
  };
  const auto drop = [&isLow](auto from, auto to) {
    for (; from != to && (!from->chosen || isLow(*from)); ++from) from->chosen = false;
  };
  drop(c.columns.begin(), c.columns.end());
  drop(std::make_reverse_iterator(c.columns.end()), std::make_reverse_iterator(c.columns.begin()));
}

double middleFoot(const Scene& scene, const GoalCandidate& c) {
  ScratchVector<double, kGoalColumns> feet;
  for (const GoalColumn& column : c.columns) {
    if (column.chosen && !column.footCut) feet.push_back(scene.frame.fromImage(column.foot).v);
  }
  if (feet.empty()) return kFarOutside;
  std::sort(feet.begin(), feet.end());
  return feet[feet.size() / 2];
}

// Columns of boards, cloth and floor whose blue is paler than the goal's paint, or than that of the
// rest, are another thing's.
void dropPale(GoalCandidate& c) {
  constexpr double kMinPaint = 0.78;
  constexpr double kMinOfRest = 0.87;  // of the upper fifth
  ScratchVector<double, kGoalColumns> paints;
  for (const GoalColumn& column : c.columns) paints.push_back(column.paint);
  if (paints.empty()) return;
  std::sort(paints.begin(), paints.end());
  const double min = std::max(kMinPaint, kMinOfRest * paints[paints.size() * 4 / 5]);
  ScratchVector<GoalColumn, kGoalColumns> kept;
  const std::size_t last = c.columns.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    // A single one at an end may be where paint and background mix.
    const bool mixed = (i == 0 && c.columns[std::min<std::size_t>(1, last)].paint >= min) ||
                       (i == last && last > 0 && c.columns[last - 1].paint >= min);
    if (mixed || c.columns[i].paint >= min) kept.push_back(c.columns[i]);
  }
  c.columns = kept;
}

// Columns at the goal's distance belong to it. So do those whose foot stands beside theirs, though
// clothes of the goal's colour rise above; their height tells nothing.
void chooseColumns(const Scene& scene, const GoalFinderParams& p, GoalCandidate& c) {
  const double reference = likelyDistance(c, p);
  for (GoalColumn& column : c.columns) {
    column.chosen =
        isMeasured(c, column, p) ? agrees(column, reference) : column.green && column.footCut;
  }
  const double foot = middleFoot(scene, c);
  for (GoalColumn& column : c.columns) {
    if (column.chosen || column.footCut || !column.green) continue;
    const double rows = std::fabs(scene.frame.fromImage(column.foot).v - foot);
    if (rows > kFootRows + kFootShare * heightOf(column)) continue;
    column.chosen = true;
    column.distance = 0.0;
  }
  if (reference > 0.0) dropLowEnds(scene, reference, c);
}

GoalColumn medianColumn(const GoalCandidate& c) {
  ScratchVector<GoalColumn, kGoalColumns> chosen;
  for (const GoalColumn& column : c.columns) {
    if (column.chosen && column.distance > 0.0) chosen.push_back(column);
  }
  if (chosen.empty()) return {};
  std::sort(chosen.begin(), chosen.end(),
            [](const auto& a, const auto& b) { return a.distance < b.distance; });
  return chosen[chosen.size() / 2];
}

// The candidate's box becomes that of its chosen columns.
void trim(const Scene& scene, GoalCandidate& c, double spacing) {
  LevelBox box = kEmptyLevelBox;
  for (const GoalColumn& column : c.columns) {
    if (!column.chosen) continue;
    const double top = scene.frame.fromImage(column.top).v;
    const double bottom = scene.frame.fromImage(column.foot).v;
    box.left = std::min(box.left, column.u);
    box.right = std::max(box.right, column.u);
    box.bottom = std::max(box.bottom, bottom);
    // A column whose height tells nothing does not tell the goal's top either.
    if (column.distance > 0.0 || column.footCut) box.top = std::min(box.top, top);
    c.topCut = c.topCut || column.topCut;
    c.bottomCut = c.bottomCut || column.footCut;
  }
  if (box.right < box.left) return;
  c.box = {std::max(c.box.left, box.left - spacing), box.top,
           std::min(c.box.right, box.right + spacing), box.bottom};
}

const GoalColumn* outermost(const GoalCandidate& c, bool left) {
  const GoalColumn* found = nullptr;
  for (const GoalColumn& column : c.columns) {
    if (!column.chosen) continue;
    if (left && found != nullptr) break;
    found = &column;
  }
  return found;
}

// Whether a robot stands where the goal seems to end: its legs hide the carpet that else lies below
// the foot beside the end. A line may cross one of the three places.
bool endHidden(const Scene& scene, const GoalColumn& column, PixelPoint end,
               ImageDirection outwards) {
  constexpr double kBeside = 2.5;                          // px from the end
  constexpr std::array<double, 3> kBelow{0.2, 0.45, 0.7};  // of the height, below the foot
  const double height = heightOf(column);
  const ImageDirection up = scene.frame.up();
  int hidden = 0;
  for (const double share : kBelow) {
    const double down = (kEndHeight + share) * height + 1.0;
    const PixelPoint at = moved(moved(end, outwards, kBeside), up, -down);
    if (!Sampler::usable(at)) continue;
    hidden += scene.sampler.classAt(at) == ColourClass::green ? 0 : 1;
  }
  return hidden >= 2;
}

// The end of the coloured wall on one side, sought a quarter of its height above the foot, where
// clothes of spectators do not reach.
GoalEnd endOf(const Scene& scene, const GoalCandidate& c, bool left, double spacing) {
  constexpr double kPastColumn = 2.0;  // px
  const GoalColumn* column = outermost(c, left);
  if (column == nullptr) return {};
  const PixelPoint start{kEndBelowTop * column->foot.x + kEndHeight * column->top.x,
                         kEndBelowTop * column->foot.y + kEndHeight * column->top.y};
  const ImageDirection right = scene.frame.right();
  const ImageDirection way = left ? -right : right;
  EdgeHit hit = walkToEdge(scene.sampler, {start, way, c.colour, kHoles});
  // Farther than the next column, which is not the goal's: something of its colour touches it.
  if (!hit.cut && hit.length > spacing + kPastColumn) hit.point = moved(start, way, 0.5 * spacing);
  return {hit.point, hit.cut, !hit.cut && endHidden(scene, *column, hit.point, way)};
}

}  // namespace

void measureGoal(const Scene& scene, const GoalFinderParams& params, const CarpetColour& carpet,
                 GoalCandidate& c) {
  const double spacing = std::max(kMinSpacing, c.box.width() / static_cast<double>(kGoalColumns));
  const CameraPose& camera = scene.body.camera;
  const PixelPoint foot = scene.frame.toImage({c.box.middle(), c.box.bottom});
  c.doubt = elevationDoubt(camera, groundRayThrough(camera, foot));
  c.columns.clear();
  for (double u = c.box.left + 0.5 * spacing; u < c.box.right; u += spacing) {
    const auto column = columnAt(scene, params, carpet, c, u);
    if (column) c.columns.push_back(*column);
  }
  dropPale(c);
  chooseColumns(scene, params, c);
  trim(scene, c, 0.5 * spacing);
  c.left = endOf(scene, c, true, spacing);
  c.right = endOf(scene, c, false, spacing);
  const GoalColumn median = medianColumn(c);
  c.wallDistance = median.distance;
  c.distanceSd = median.sd;
  c.footError = median.footError;
}

}  // namespace kelpie::vision
