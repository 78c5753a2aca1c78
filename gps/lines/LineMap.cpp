// SPDX-License-Identifier: Apache-2.0
#include "gps/lines/LineMap.h"

#include <algorithm>
#include <cmath>

#include "gps/pose/Predict.h"

namespace kelpie::gps {
namespace {

constexpr double kStillStep = 1e-3;        // cm and rad a frame
constexpr double kMaxCoordinate = 1e3;     // cm
constexpr double kMinRangeSquared = 1e-6;  // cm2; nearer, a point has no direction

bool usable(const LinePoint& p) {
  return std::isfinite(p.position.x) && std::isfinite(p.position.y) &&
         std::fabs(p.position.x) < kMaxCoordinate && std::fabs(p.position.y) < kMaxCoordinate &&
         p.weight > 0.0 && p.weight <= 1.0;
}

double square2(Point2<Robot> p) { return p.x * p.x + p.y * p.y; }

// Radius of the larger of both regions, so that it does not matter which came first.
double regionOf(const MapPoint& a, const MapPoint& b, const LineMapParams& params) {
  const double far = std::sqrt(std::max(square2(a.place), square2(b.place)));
  if (a.kind == LinePointKind::field) return params.carpetRadius + params.carpetShare * far;
  return params.radius + params.radiusShare * far;
}

bool inOneDirection(Point2<Robot> a, Point2<Robot> b, Angle angle) {
  const double dot = a.x * b.x + a.y * b.y;
  const double squares = square2(a) * square2(b);
  if (squares < kMinRangeSquared) return true;
  const double cosine = angle.cos();
  return dot > 0.0 && dot * dot >= cosine * cosine * squares;
}

// Half the side of a square beyond which nothing lies in one region with the point. Compared with
// every point of the map first, it saves four of five instructions.
double boundOf(const MapPoint& point, const LineMapParams& params) {
  const bool green = point.kind == LinePointKind::field;
  const double share = green ? params.carpetShare : params.radiusShare;
  const double radius = green ? params.carpetRadius : params.radius;
  return (radius + share * std::sqrt(square2(point.place))) / std::max(1.0 - share, 1e-3);
}

bool isBeyond(const MapPoint& a, const MapPoint& b, double bound) {
  return a.kind != b.kind || std::fabs(a.place.x - b.place.x) > bound ||
         std::fabs(a.place.y - b.place.y) > bound;
}

// A merged point's place is the mean weighted by the counts: each sighting counts the same.
MapPoint merged(const MapPoint& a, const MapPoint& b, const LineMapParams& params) {
  MapPoint sum = a;
  const double share = b.decayedCount / (a.decayedCount + b.decayedCount);
  sum.place = a.place + (b.place - a.place) * share;
  sum.weight += share * (b.weight - a.weight);
  sum.decayedCount = std::min(a.decayedCount + b.decayedCount, params.maxCount);
  return sum;
}

void remove(std::size_t index, LineMap& map) {
  map.points[index] = map.points.back();
  map.points.resize(map.points.size() - 1);
}

void decay(double elapsed, const LineMapParams& params, LineMap& map) {
  map.age += elapsed;
  map.sinceDecay += elapsed;
  if (map.sinceDecay < params.decay) return;
  map.sinceDecay -= params.decay;
  for (std::size_t i = 0; i < map.points.size();) {
    map.points[i].decayedCount -= 1.0;
    if (map.points[i].decayedCount > 0.0) {
      ++i;
    } else {
      remove(i, map);
    }
  }
}

// Points on green say little: they must not take the room of the lines.
bool hasCapacity(const LineMap& map, LinePointKind kind, const LineMapParams& params) {
  return kind != LinePointKind::field || countOf(map, kind) < params.maxCarpet;
}

// A robot that is carried does not notice it, but its points match none of the map.
void noteUnmatched(bool unmatched, LineMap& map) {
  constexpr double kSmoothing = 1.0 / 300.0;  // a second of some ten points a frame
  map.unmatchedShare += kSmoothing * ((unmatched ? 1.0 : 0.0) - map.unmatchedShare);
}

// As a new one; of its 5 KB only what is used is written, since it is asked in each frame of a
// walk.
void clear(LineMap& map) {
  map.points.clear();
  map.age = map.sinceDecay = map.newCount = map.unmatchedShare = 0.0;
  map.refused = 0;
}

bool isStale(const LineMap& map, const LineMapParams& params) {
  return map.refused > params.maxRefused || map.unmatchedShare > params.maxUnmatchedShare;
}

void addKind(const FixedVector<LinePoint, 256>& points, LinePointKind kind, std::size_t max,
             const LineMapParams& params, LineMap& map) {
  constexpr double kSettledSeconds = 2.0;  // s
  std::size_t count = 0;
  for (const LinePoint& p : points) count += p.kind == kind ? 1 : 0;
  std::size_t index = 0;
  for (const LinePoint& p : points) {
    if (p.kind != kind) continue;
    if (!isSpread(index++, count, max)) continue;
    const bool unmatched = !add(p, params, map);
    if (kind != LinePointKind::field && map.age > kSettledSeconds) noteUnmatched(unmatched, map);
  }
}

}  // namespace

bool standing(const FrameInput& input) {
  const Odometry& way = input.odometry;
  const WalkRequest& walk = input.lastCommand.walk;
  return std::fabs(way.forward) < kStillStep && std::fabs(way.left) < kStillStep &&
         std::fabs(way.turn.rad()) < kStillStep && walk.forward == 0.0 && walk.left == 0.0 &&
         walk.turn == 0.0 && input.lastCommand.motion == MotionKind::none &&
         input.motion.running == MotionKind::none;
}

bool inOneRegion(const MapPoint& a, const MapPoint& b, const LineMapParams& params) {
  if (a.kind != b.kind) return false;
  const double reach = regionOf(a, b, params);
  if (square2(a.place - b.place) > reach * reach) return false;
  return a.kind == LinePointKind::field || inOneDirection(a.place, b.place, params.angle);
}

bool add(const LinePoint& point, const LineMapParams& params, LineMap& map) {
  if (!usable(point)) return false;
  MapPoint mine{point.kind, point.position, point.weight, 1.0};
  double gained = 1.0;
  bool isNew = true;
  double bound = boundOf(mine, params);
  for (std::size_t i = 0; i < map.points.size();) {
    if (isBeyond(map.points[i], mine, bound) || !inOneRegion(map.points[i], mine, params)) {
      ++i;
      continue;
    }
    const MapPoint other = map.points[i];
    mine = merged(other, mine, params);
    bound = boundOf(mine, params);
    if (isNew) gained = mine.decayedCount - other.decayedCount;  // 0 where enough has been seen
    isNew = false;
    remove(i, map);
    i = 0;  // it has moved, perhaps into another's region
  }
  if (isNew && !hasCapacity(map, mine.kind, params)) return false;
  if (map.points.push_back(mine) && mine.kind != LinePointKind::field) map.newCount += gained;
  return !isNew;
}

void stepMap(const FrameInput& input, const FixedVector<LinePoint, 256>& points,
             const LinesParams& params, LineMap& map) {
  const LineMapParams& p = params.map;
  if (!p.use || !standing(input) || isStale(map, p)) clear(map);
  if (!p.use || !standing(input)) return;
  addKind(points, LinePointKind::line, params.update.maxPoints, p, map);
  addKind(points, LinePointKind::border, params.update.maxPoints, p, map);
  addKind(points, LinePointKind::field, 12, p, map);
  decay(elapsedOf(input), p, map);
}

SeenLines seenLines(const LineMap& map, std::size_t max, const LineMapParams& params) {
  SeenLines seen;
  const std::size_t count = countOfWhite(map);
  const std::size_t green = countOf(map, LinePointKind::field);
  double matched = 0.0;
  std::size_t line = 0;
  std::size_t carpet = 0;
  for (const MapPoint& p : map.points) {
    const SeenPoint point{p.place,
                          p.weight * std::min(1.0, p.decayedCount / params.fullWeightCount),
                          p.kind == LinePointKind::border};
    if (p.kind == LinePointKind::field && isSpread(carpet++, green, 12))
      seen.carpet.push_back(point);
    if (p.kind == LinePointKind::field || !isSpread(line++, count, max)) continue;
    seen.lines.push_back(point);
    matched += point.weight;
  }
  seen.newEvidenceShare = matched > 0.0 ? std::min(1.0, map.newCount / matched) : 0.0;
  return seen;
}

std::size_t countOf(const LineMap& map, LinePointKind kind) {
  std::size_t count = 0;
  for (const MapPoint& p : map.points) count += p.kind == kind ? 1 : 0;
  return count;
}

std::size_t countOfWhite(const LineMap& map) {
  return countOf(map, LinePointKind::line) + countOf(map, LinePointKind::border);
}

}  // namespace kelpie::gps
