// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/body/StartPlace.h"

#include <algorithm>
#include <cmath>

#include "tools/calibrate/Quantile.h"

namespace kelpie::calibrate {
namespace {

struct Direction {
  Point2<Field> place;
  double heading = 0.0;   // rad, in the robot frame
  double distance = 0.0;  // cm
};

// The median of what was seen of each kind.
std::vector<Direction> directions(const StandingLog& log, const Seen& seen) {
  std::vector<Direction> found;
  for (const body::Landmark& known : body::landmarksFor(log.config->field, log.config->team)) {
    std::vector<double> headings;
    std::vector<double> distances;
    for (const Percepts& percepts : seen.percepts)
      for (const LandmarkPercept& percept : percepts.landmarks) {
        if (percept.kind != known.kind || percept.leftEdgeCut || percept.rightEdgeCut) continue;
        headings.push_back(percept.heading.rad());
        distances.push_back(percept.distance);
      }
    if (headings.size() >= 2)
      found.push_back({known.position, quantile(headings, 0.5), quantile(distances, 0.5)});
  }
  return found;
}

struct Guess {
  Pose2 pose;
  double cost = 1e9;
};

// The best heading there, and how ill it fits.
Guess guessAt(Point2<Field> position, const std::vector<Direction>& seen) {
  constexpr double kHeadingSd = 0.05;   // rad: the play of the pan
  constexpr double kDistanceSd = 0.12;  // share
  constexpr double kMaxOfOne = 9.0;     // a false one does not decide
  double s = 0.0;
  double c = 0.0;
  std::vector<double> turns;
  for (const Direction& d : seen) {
    const Point2<Field> way = d.place - position;
    turns.push_back(maths::atan2(way.y, way.x) - d.heading);
    s += std::sin(turns.back());
    c += std::cos(turns.back());
  }
  const double heading = maths::atan2(s, c);
  Guess guess{{position, Angle::rad(heading)}, 0.0};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double turn = std::remainder(turns[i] - heading, 2.0 * maths::kPi) / kHeadingSd;
    const double away = std::max(distance(seen[i].place, position), 10.0);
    const double size = std::log(seen[i].distance / away) / kDistanceSd;
    guess.cost += std::min(turn * turn, kMaxOfOne) + std::min(size * size, kMaxOfOne);
  }
  return guess;
}

}  // namespace

std::size_t landmarkKinds(const Seen& seen) {
  std::array<int, kLandmarkKindCount> count{};
  for (const Percepts& percepts : seen.percepts)
    for (const LandmarkPercept& percept : percepts.landmarks)
      ++count[static_cast<std::size_t>(percept.kind)];
  return static_cast<std::size_t>(
      std::count_if(count.begin(), count.end(), [](int n) { return n >= 2; }));
}

std::optional<Pose2> startPlace(const StandingLog& log, const Seen& seen) {
  constexpr double kGrid = 5.0;  // cm
  const std::vector<Direction> found = directions(log, seen);
  if (found.size() < 2) return std::nullopt;
  const body::Carpet carpet = body::carpetOf(log.config->field);
  Guess best;
  for (double x = carpet.low.x; x <= carpet.high.x; x += kGrid)
    for (double y = carpet.low.y; y <= carpet.high.y; y += kGrid) {
      const Guess here = guessAt({x, y}, found);
      if (here.cost < best.cost) best = here;
    }
  return best.pose;
}

}  // namespace kelpie::calibrate
