// SPDX-License-Identifier: Apache-2.0
#include "gps/pinks/PinkUpdate.h"

#include <algorithm>

#include "gps/Refusal.h"
#include "gps/pinks/PinkMap.h"
#include "gps/pose/Modes.h"
#include "gps/pose/Outliers.h"
#include "gps/pose/PoseUpdate.h"

namespace kelpie::gps {
namespace {

// Keeps the heaviest of all that are offered: M (N + 1) modes can be more than there is room for.
void keepHeaviest(const PoseMode& mode, Modes& best) {
  if (best.push_back(mode)) return;
  PoseMode* lightest =
      std::min_element(best.begin(), best.end(),
                       [](const PoseMode& a, const PoseMode& b) { return a.weight < b.weight; });
  if (lightest->weight < mode.weight) *lightest = mode;
}

Measurement headingOf(const PinkBearing& bearing, Point2<Field> landmark, const Pose2& pose,
                      const PinkContext& context) {
  const double away = distance(landmark, pose.position);
  constexpr double kMinDistance = 50.0;  // cm; nearer, mapSd would be no small angle
  Measurement m;
  m.landmark = landmark;
  m.useHeading = true;
  m.heading = headingAt(bearing, away);
  m.headingVariance = std::max(context.gates.headingVarianceFactor * bearing.variance,
                               maths::square(context.pinks.minBearingSd.rad())) +
                      maths::square(context.pinks.mapSd / std::max(kMinDistance, away));
  return m;
}

bool fits(const PinkBearing& bearing, const PoseMode& mode, Point2<Field> landmark,
          const PinkMapParams& params) {
  const Point2<Field> eye = fieldFromRobot(mode.pose, bearing.eye);
  return mayHangOnWall(bearing.eyeHeight, bearing.elevation, distance(eye, landmark), params);
}

// Pink clothes above the wall are no evidence of anything. Where the wall is the best mode says.
bool isAboveWall(const PinkBearing& bearing, const PinkMapParams& params, const Pose2& pose) {
  const Ray ray = rayOf(pose, bearing);
  const auto place = meetWall(ray, params.wall);
  return place &&
         !mayHangOnWall(bearing.eyeHeight, bearing.elevation, distance(*place, ray.from), params);
}

}  // namespace

PinkLandmarks knownPinks(const PinkState& state, const PinkMapParams& params) {
  PinkLandmarks known;
  for (const PinkLandmark& landmark : state.map)
    if (landmark.weight >= params.minWeight) known.push_back(landmark);
  return known;
}

bool updateByPink(const PinkBearing& bearing, const PinkContext& context, PinkState& pinks,
                  Modes& modes) {
  const PinkLandmarks known = knownPinks(pinks, context.pinks);
  if (known.empty()) return false;
  const ModeParams& params = context.modes;
  Modes best;
  SplitWeights weights;
  for (const PoseMode& mode : modes) {
    const PoseMode copy = outlierCopy(mode, params.outlierWeight);
    weights.copies += copy.weight;
    keepHeaviest(copy, best);
    for (const PinkLandmark& landmark : known) {
      if (!fits(bearing, mode, landmark.position, context.pinks)) continue;
      const Measurement heading = headingOf(bearing, landmark.position, mode.pose, context);
      PoseMode moved = corrected(mode, heading);
      moved.weight /= static_cast<double>(known.size());
      weights.corrected += moved.weight;
      keepHeaviest(moved, best);
    }
  }
  countUnexplained(weights, params.explainedShare, 1, pinks.unexplained);
  modes = best;
  return true;
}

void updateByPatches(const PinkBearings& bearings, const PinkContext& context, PinkState& pinks,
                     PoseState& pose, GpsCounts& counts) {
  const std::size_t max = std::min<std::size_t>(bearings.size(), context.pinks.maxPatches);
  for (std::size_t i = 0; i < max; ++i) {
    if (isAboveWall(bearings[i], context.pinks, pose.modes[0].pose)) {
      count(Refusal::pinkElevation, counts);
    } else if (updateByPink(bearings[i], context, pinks, pose.modes)) {
      mergeAndPrune(context.field.description, context.modes, pose, counts);
    }
  }
}

}  // namespace kelpie::gps
