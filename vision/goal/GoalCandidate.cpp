// SPDX-License-Identifier: Apache-2.0
#include "vision/goal/GoalCandidate.h"

#include <algorithm>

#include "vision/pixels/GroundRay.h"

namespace kelpie::vision {

LandmarkKind goalKind(ColourClass colour) {
  return colour == ColourClass::blue ? LandmarkKind::goalBlue : LandmarkKind::goalYellow;
}

double visibleWidth(const Scene& scene, const GoalCandidate& c) {
  const CameraPose& camera = scene.body.camera;
  constexpr double kMinDistance = 5.0;  // cm, to the mouth
  const double d = std::max(c.wallDistance - scene.field.goalDepth, kMinDistance);
  return distance(placeAt(camera, groundRayThrough(camera, c.left.point), d),
                  placeAt(camera, groundRayThrough(camera, c.right.point), d));
}

GoalFeet feetOf(const Scene& scene, const GoalCandidate& c) {
  GoalFeet feet;
  for (const GoalColumn& column : c.columns) {
    if (!column.chosen || column.footCut) continue;
    const double below = belowFieldEdge(scene, column.foot);
    feet.lowest = std::max(feet.lowest, below);
    feet.sum += below;
    ++feet.count;
  }
  return feet;
}

ColumnCounts countColumns(const GoalCandidate& c) {
  ColumnCounts counts;
  for (const GoalColumn& column : c.columns) {
    if (!column.chosen) continue;
    ++counts.chosen;
    counts.measured += column.distance > 0.0 ? 1 : 0;
  }
  return counts;
}

}  // namespace kelpie::vision
