// SPDX-License-Identifier: Apache-2.0
// How far goals that the image's border or robots cut are off in heading and distance, beside whole
// ones, and whether their variances say so: the mean of the squared error over the variance should
// be near one. False percepts, which match no goal that may show, are left out.
#include <algorithm>
#include <array>
#include <cmath>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/views/Looks.h"
#include "tools/experiments/views/Objects.h"

namespace kelpie::experiments {
namespace {

constexpr double kFar = 250.0;  // cm, beyond which gps takes no distance of a goal

// Squared errors of one kind of goal.
struct Errors {
  Values headingDeg;
  Values headingNees;
  Values distancePct;
  Values distanceNees;
  Values edgeDeg;  // of posts that are said to be seen

  void add(const LandmarkPercept& p, const TrueObject& goal) {
    const Angle heading = p.heading - goal.heading;
    const double distance = p.distance - goal.distance;
    headingDeg.push_back(std::fabs(heading.deg()));
    headingNees.push_back(heading.rad() * heading.rad() / p.headingVariance);
    distancePct.push_back(100.0 * std::fabs(distance) / goal.distance);
    distanceNees.push_back(distance * distance / p.distanceVariance);
  }
  Json figures() const {
    return {{"goals", headingDeg.size()},
            {"heading_rms_deg", rms(headingDeg)},
            {"heading_p99_deg", percentile(headingDeg, 0.99)},
            {"heading_nees", mean(headingNees)},
            {"heading_nees_p99", percentile(headingNees, 0.99)},
            {"distance_rms_pct", rms(distancePct)},
            {"distance_nees", mean(distanceNees)},
            {"distance_nees_p99", percentile(distanceNees, 0.99)},
            {"edge_rms_deg", rms(edgeDeg)}};
  }
};

// A post's heading from the robot.
Angle postHeading(const View& view, const body::FieldDescription& field, LandmarkKind kind,
                  bool left) {
  const Point2<Field> goal = body::findLandmark(field.landmarks, kind)->position;
  const double out = goal.y > 0.5 * field.length ? -1.0 : 1.0;
  const double lateral = 0.5 * field.goalWidth * (left ? out : -out);
  return bearing(robotFromField(view.pose, {goal.x + lateral, goal.y}));
}

Expected<Json> cutGoals(const Request& request) {
  const ViewParams params;
  Visibility visibility;
  // Ends in view (both, one, none), near and far.
  std::array<Errors, 6> errors;
  lookAtViews(params, request, [&](const Look& look) {
    const auto objects = trueObjects(look.view, params.field, visibility);
    for (const LandmarkPercept& p : look.seen.landmarks) {
      const auto goal = std::find_if(objects.begin(), objects.end(), [&](const TrueObject& o) {
        return matches(seenObject(p), o) && o.kind == ObjectKind::goal;
      });
      if (goal == objects.end()) continue;
      const std::size_t cut = (p.leftEdgeCut ? 1U : 0U) + (p.rightEdgeCut ? 1U : 0U);
      Errors& of = errors[2 * cut + (goal->distance > kFar ? 1U : 0U)];
      of.add(p, *goal);
      if (!p.leftEdgeCut)
        of.edgeDeg.push_back(
            (p.leftEdge - postHeading(look.view, params.field, p.kind, true)).deg());
      if (!p.rightEdgeCut)
        of.edgeDeg.push_back(
            (p.rightEdge - postHeading(look.view, params.field, p.kind, false)).deg());
    }
  });
  return Json{{"whole_near", errors[0].figures()},   {"whole_far", errors[1].figures()},
              {"one_end_near", errors[2].figures()}, {"one_end_far", errors[3].figures()},
              {"no_end_near", errors[4].figures()},  {"no_end_far", errors[5].figures()}};
}

const Registration kCutGoals("cut-goals",
                             "goals that borders or robots cut: errors of heading and distance",
                             {Option::trials, Option::seed, Option::randomised}, 6000, cutGoals);

}  // namespace
}  // namespace kelpie::experiments
