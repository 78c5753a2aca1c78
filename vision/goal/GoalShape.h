// SPDX-License-Identifier: Apache-2.0
// Where a goal stands: its three walls, as wide and deep as the field says, are laid through the
// distances of its columns and the directions of its two ends (Gauss-Newton from three turns). Seen
// obliquely, the outside of the near wall shows beside the mouth and the back wall is farther than
// the mouth, which a distance and two ends alone do not tell apart. Weak when the image or robots
// hide both ends.
#pragma once

#include <optional>

#include "vision/goal/GoalCandidate.h"

namespace kelpie::vision {

// Relative to the camera: x to the right, y forward, as in the robot frame.
struct GoalShape {
  bool valid = false;
  Point2<Robot> middle;  // of the mouth
  double turn = 0.0;     // rad, of the mouth's line from the robot frame's x axis
  double cost = 0.0;     // sum of squared errors in standard deviations

  // rad from square to the line of sight, and cm of the camera from the goal's axis.
  double obliqueAngle() const;
  double lateralOffset() const;

  Point2<Robot> leftPost(const body::FieldDescription& field) const;
  Point2<Robot> rightPost(const body::FieldDescription& field) const;
  // From the camera to the first wall in a direction (unit vector); nothing beside the goal.
  std::optional<double> wallAlong(Point2<Robot> way, const body::FieldDescription& field) const;
};

// A check, true = keep: the mouth is seen from the field, not from behind or from the goal line.
bool goalFacesField(const GoalShape& shape, const GoalFinderParams& params);

GoalShape fitGoal(const Scene& scene, const GoalCandidate& c);

}  // namespace kelpie::vision
