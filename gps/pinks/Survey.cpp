// SPDX-License-Identifier: Apache-2.0
#include "gps/pinks/Survey.h"

#include <algorithm>
#include <cmath>

namespace kelpie::gps {
namespace {

// A point of the robot frame in the survey's.
Point2<Robot> inSurvey(const Survey& survey, Point2<Robot> p) {
  const double s = survey.turned.sin();
  const double c = survey.turned.cos();
  return {survey.place.x + c * p.x - s * p.y, survey.place.y + s * p.x + c * p.y};
}

void addPoint(const LinePoint& point, const PinkPoseSearchParams& params, Survey& survey) {
  const double away = point.position.norm();
  if (!std::isfinite(away) || away > params.farthest || !(point.weight > 0.0)) return;
  const Point2<Robot> place = inSurvey(survey, point.position);
  for (const SurveyPoint& known : survey.points)
    if (std::fabs(known.place.x - place.x) < params.cell &&
        std::fabs(known.place.y - place.y) < params.cell)
      return;
  survey.points.push_back({place, point.weight});
}

void addBearing(const PinkBearing& bearing, const PinkPoseSearchParams& params, Survey& survey) {
  const Angle heading = survey.turned + bearing.heading;
  const Point2<Robot> eye = inSurvey(survey, bearing.eye);
  for (SurveyBearing& known : survey.bearings) {
    const Angle apart = heading - known.heading;
    if (apart.abs().rad() > params.sameBearing.rad() ||
        distance(known.origin, eye) > params.sameOrigin)
      continue;
    known.weight += 1.0;
    known.heading = known.heading + apart * (1.0 / known.weight);
    known.elevation =
        known.elevation + (bearing.elevation - known.elevation) * (1.0 / known.weight);
    known.origin = known.origin + (eye - known.origin) * (1.0 / known.weight);
    return;
  }
  survey.bearings.push_back({eye, bearing.eyeHeight, heading, bearing.elevation, 1.0});
}

}  // namespace

void moveSurvey(const Odometry& odometry, double elapsed, Survey& survey) {
  const Angle before = survey.turned;
  survey.turned = before + odometry.turn * 0.5;  // the step lies between the two directions
  survey.place = inSurvey(survey, {-odometry.left, odometry.forward});
  survey.turned = before + odometry.turn;
  survey.seconds += elapsed;
}

void addToSurvey(const FixedVector<LinePoint, 256>& points, const PinkBearings& bearings,
                 const PinkPoseSearchParams& params, Survey& survey) {
  for (const LinePoint& point : points)
    if (point.kind == LinePointKind::line) addPoint(point, params, survey);
  for (const PinkBearing& bearing : bearings) addBearing(bearing, params, survey);
}

SeenLines linesOf(const Survey& survey, std::size_t max) {
  SeenLines seen;
  const std::size_t count = survey.points.size();
  const std::size_t wanted = std::min(count, max);
  for (std::size_t i = 0; i < wanted; ++i) {
    const SurveyPoint& point = survey.points[i * count / wanted];
    seen.lines.push_back({point.place, point.weight});
  }
  return seen;
}

Pose2 poseNow(const Survey& survey, const Pose2& start) {
  return {fieldFromRobot(start, survey.place), start.heading + survey.turned};
}

}  // namespace kelpie::gps
