// SPDX-License-Identifier: Apache-2.0
#include "gps/pinks/PinkPoseSearch.h"

#include <algorithm>
#include <cmath>

#include "gps/pinks/PinkMap.h"

namespace kelpie::gps {
namespace {

constexpr std::size_t kCoarsePoints = 40;
constexpr double kSamePlace = 30.0;  // cm; candidates nearer to each other are one
constexpr double kSameTurn = 20.0;   // deg
constexpr std::size_t kMinFitPoints = 8;

bool samePose(const PoseCandidate& a, const PoseCandidate& b) {
  return distance(a.pose.position, b.pose.position) < kSamePlace &&
         (a.pose.heading - b.pose.heading).abs().deg() < kSameTurn;
}

// Keeps the best of those that are one, and the best of all when there is no more room.
void keep(const PoseCandidate& candidate, PinkPoseSearch& search) {
  auto& kept = search.candidates;
  PoseCandidate* worst = kept.begin();
  for (PoseCandidate& other : kept) {
    if (samePose(candidate, other)) {
      if (candidate.score > other.score) other = candidate;
      return;
    }
    if (other.score < worst->score) worst = &other;
  }
  if (kept.push_back(candidate) || candidate.score <= worst->score) return;
  *worst = candidate;
}

struct Grid {
  std::uint32_t columns;
  std::uint32_t rows;
  std::uint32_t turns;

  std::uint32_t size() const { return columns * rows * turns; }
};

Grid gridOf(const body::FieldDescription& field, const PinkPoseSearchParams& p) {
  const auto steps = [](double length, double step) {
    return static_cast<std::uint32_t>(length / step) + 1;
  };
  return {steps(field.width, p.step), steps(field.length, p.step),
          static_cast<std::uint32_t>(2.0 * maths::kPi / p.turnStep.rad() + 0.5)};
}

Pose2 poseAt(std::uint32_t index, const Grid& grid, const body::FieldDescription& field) {
  const std::uint32_t turn = index % grid.turns;
  const std::uint32_t column = index / grid.turns % grid.columns;
  const std::uint32_t row = index / grid.turns / grid.columns;
  return {{(column + 0.5) * field.width / grid.columns, (row + 0.5) * field.length / grid.rows},
          Angle::rad(2.0 * maths::kPi * turn / grid.turns)};
}

void tryPoses(const Survey& survey, const PinkLandmarks& pinks, const PinkContext& context,
              PinkPoseSearch& search) {
  const PinkPoseSearchParams& p = context.pinks.search;
  const body::FieldDescription& field = context.field.description;
  const Grid grid = gridOf(field, p);
  const SeenLines lines = linesOf(survey, kCoarsePoints);
  const std::uint32_t end = std::min(grid.size(), search.cursor + p.startsPerFrame);
  for (; search.cursor < end; ++search.cursor) {
    PoseCandidate candidate;
    candidate.pose = poseAt(search.cursor, grid, field);
    candidate.match = surveyMatch(lines, candidate.pose, context.field.features, p.coarseSharpness);
    candidate.score = p.lineScore * candidate.match +
                      bearingScore(survey, candidate.pose, pinks, p.coarseBearingSd, context.pinks);
    keep(candidate, search);
  }
}

void refine(const Survey& survey, const PinkLandmarks& pinks, const PinkContext& context,
            PoseCandidate& candidate) {
  const PinkPoseSearchParams& p = context.pinks.search;
  const FieldFeatures& features = context.field.features;
  const SeenLines lines = linesOf(survey, kSurveyPoints);
  if (lines.lines.size() >= kMinFitPoints)
    candidate.pose = fitLines(lines, candidate.pose, features, context.lines, true).pose;
  candidate.match = surveyMatch(lines, candidate.pose, features, p.fineSharpness);
  candidate.score = p.lineScore * candidate.match +
                    bearingScore(survey, candidate.pose, pinks, p.bearingSd, context.pinks);
}

// Sum over the mapped pinks of how well the ray points at each.
double shareOfPinks(const Ray& ray, const PinkLandmarks& pinks, Angle sd) {
  const double perVariance = 0.5 / maths::square(sd.rad());
  double sum = 0.0;
  for (const PinkLandmark& pink : pinks) {
    const Point2<Field> way = pink.position - ray.from;
    const double aside = ray.along.x * way.y - ray.along.y * way.x;
    const double away2 = way.x * way.x + way.y * way.y;
    const bool ahead = ray.along.x * way.x + ray.along.y * way.y > 0.0;
    if (ahead) sum += maths::exp(-perVariance * aside * aside / away2);  // sine for angle
  }
  return sum;
}

}  // namespace

double surveyMatch(const SeenLines& lines, const Pose2& start, const FieldFeatures& field,
                   double sharpness) {
  const double s = start.heading.sin();
  const double c = start.heading.cos();
  double sum = 0.0;
  double all = 0.0;
  for (const SeenPoint& point : lines.lines) {
    const Point2<Robot> p = point.place;
    const Point2<Field> place{start.position.x + s * p.x + c * p.y,
                              start.position.y - c * p.x + s * p.y};
    const double away = field.nearest(place).value;
    sum += point.weight / (1.0 + sharpness * away * away);
    all += point.weight;
  }
  return all > 0.0 ? sum / all : 0.0;
}

double bearingScore(const Survey& survey, const Pose2& start, const PinkLandmarks& pinks, Angle sd,
                    const PinkMapParams& params) {
  if (pinks.empty()) return 0.0;
  double score = 0.0;
  for (const SurveyBearing& seen : survey.bearings) {
    const Angle direction = start.heading + seen.heading;
    const Ray ray{fieldFromRobot(start, seen.origin), {direction.cos(), direction.sin()}};
    const auto place = meetWall(ray, params.wall);
    const bool onWall =
        place && mayHangOnWall(seen.eyeHeight, seen.elevation, distance(*place, ray.from), params);
    const double sum = onWall ? shareOfPinks(ray, pinks, sd) : 0.0;
    score += maths::log(params.search.missed + sum / static_cast<double>(pinks.size()));
  }
  return score;
}

bool stepPinkPoseSearch(const Survey& survey, const PinkLandmarks& pinks,
                        const PinkContext& context, PinkPoseSearch& search) {
  const PinkPoseSearchParams& p = context.pinks.search;
  if (search.cursor < gridOf(context.field.description, p).size()) {
    tryPoses(survey, pinks, context, search);
    return false;
  }
  for (std::uint32_t i = 0; i < p.refinedPerFrame; ++i) {
    if (search.refined >= search.candidates.size()) break;
    refine(survey, pinks, context, search.candidates[search.refined++]);
  }
  if (search.refined < search.candidates.size()) return false;
  std::stable_sort(
      search.candidates.begin(), search.candidates.end(),
      [](const PoseCandidate& a, const PoseCandidate& b) { return a.score > b.score; });
  return true;
}

double sureness(const PinkPoseSearch& search) {
  if (search.candidates.empty()) return 0.0;
  const PoseCandidate& best = search.candidates[0];
  double elsewhere = 0.0;
  for (const PoseCandidate& other : search.candidates)
    if (!samePose(best, other)) elsewhere += maths::exp(other.score - best.score);
  return 1.0 / (1.0 + elsewhere);
}

}  // namespace kelpie::gps
