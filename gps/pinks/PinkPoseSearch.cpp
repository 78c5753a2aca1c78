// SPDX-License-Identifier: Apache-2.0
#include "gps/pinks/PinkPoseSearch.h"

#include <optional>

#include "gps/SamePose.h"
#include "gps/pinks/PinkMap.h"

namespace kelpie::gps {
namespace {

constexpr std::size_t kCoarsePoints = 40;
constexpr double kSameDistance = 30.0;  // cm; poses nearer to each other are one
constexpr double kSameTurn = 20.0;      // deg
constexpr std::size_t kMinFitPoints = 8;

PoseGrid gridOf(const body::FieldDescription& field, const PinkPoseSearchParams& p) {
  const auto steps = [](double length, double step) {
    return static_cast<std::uint32_t>(length / step) + 1;
  };
  return {field.width, field.length, steps(field.width, p.step), steps(field.length, p.step),
          static_cast<std::uint32_t>(2.0 * maths::kPi / p.turnStep.rad() + 0.5)};
}

// Scored by log likelihood, up to a constant; only the refined poses are fitted to the lines.
struct SurveyScene {
  const Survey& survey;
  const PinkLandmarks& pinks;
  const PinkContext& context;
  SeenLines few;
  SeenLines all;

  double score(const SeenLines& lines, const Pose2& pose, double sharpness, Angle sd) const {
    return context.pinks.search.lineScore *
               surveyMatch(lines, pose, context.field.features, sharpness) +
           bearingScore(survey, pose, pinks, sd, context.pinks);
  }
  std::optional<FoundPose> tried(const Pose2& start) const {
    const PinkPoseSearchParams& p = context.pinks.search;
    return FoundPose{start, score(few, start, p.coarseSharpness, p.coarseBearingSd)};
  }
  FoundPose refined(const FoundPose& found) const {
    const PinkPoseSearchParams& p = context.pinks.search;
    Pose2 pose = found.pose;
    if (all.lines.size() >= kMinFitPoints)
      pose = fitLines(all, pose, context.field.features, context.lines, true).pose;
    return {pose, score(all, pose, p.fineSharpness, p.bearingSd)};
  }
  bool same(const Pose2& a, const Pose2& b) const {
    return samePose(a, b, kSameDistance, kSameTurn);
  }
};

// Sum over the mapped pinks of how well the ray points at each.
double shareOfPinks(const Ray& ray, const PinkLandmarks& pinks, Angle sd) {
  const double perVariance = 0.5 / maths::square(sd.rad());
  double sum = 0.0;
  for (const PinkLandmark& pink : pinks) {
    const Point2<Field> way = pink.position - ray.from;
    const double lateral = ray.along.x * way.y - ray.along.y * way.x;
    const double away2 = way.x * way.x + way.y * way.y;
    const bool ahead = ray.along.x * way.x + ray.along.y * way.y > 0.0;
    if (ahead) sum += maths::exp(-perVariance * lateral * lateral / away2);  // sine for angle
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
                        const PinkContext& context, PoseSearch& search) {
  const PinkPoseSearchParams& p = context.pinks.search;
  const SurveyScene scene{survey, pinks, context, linesOf(survey, kCoarsePoints),
                          linesOf(survey, kSurveyPoints)};
  const PoseSearchPace pace{p.startsPerFrame, p.refinedPerFrame, FoundPoses::kCapacity};
  return stepPoseSearch(gridOf(context.field.description, p), pace, scene, search);
}

double sureness(const FoundPoses& found) {
  double sum = 0.0;
  for (const FoundPose& pose : found) sum += maths::exp(pose.score - found[0].score);
  return found.empty() ? 0.0 : 1.0 / sum;
}

}  // namespace kelpie::gps
