// SPDX-License-Identifier: Apache-2.0
// Where on the outer wall the pink patches hang (thesis 2004 section 4.1.2): the ray from the
// robot's pose through the patch meets the wall. Only as good as the pose and the measured wall.
#pragma once

#include <optional>

#include "gps/pinks/PinkBearing.h"
#include "gps/pinks/PinkMapParams.h"
#include "gps/pinks/PinkState.h"
#include "gps/pose/PoseState.h"
#include "robot/body/FieldDescription.h"

namespace kelpie::gps {

struct Ray {
  Point2<Field> from;
  Point2<Field> along;  // unit vector
};
Ray rayOf(const Pose2& pose, const PinkBearing& bearing);

// The nearest place ahead at which the ray meets the wall; the wall need not be a rectangle.
std::optional<Point2<Field>> meetWall(const Ray& ray, const std::array<double, 8>& wall);

// What a camera at eyeHeight sees at that elevation can hang on a wall that far away: its middle is
// between minHeight and maxHeight there. The highest elevation falls with the distance (thesis 2004
// section 4.1.2).
bool mayHangOnWall(double eyeHeight, Angle elevation, double distance, const PinkMapParams& params);

// The ray passes no beacon within the clearance; beacons behind the robot do not count.
bool clearOfBeacons(const Ray& ray, const body::LandmarkMap& landmarks, double clearance);

// Along a wall a ray's small error is a long way: the mapped patch that it passes closely, though
// it meets the wall farther from it than patches are merged; null when there is none.
PinkLandmark* glancedAt(const Ray& ray, Point2<Field> place, const PinkMapParams& params,
                        PinkLandmarks& map);

// Adds a sighting of weight 1, or merges it into the nearest entry within the radius, by weight.
// False when the map is full.
bool addToMap(Point2<Field> place, double mergeRadius, PinkLandmarks& map);

// Takes one from every weight each `forgetSeconds` and drops what has none left.
void forget(double seconds, const PinkMapParams& params, PinkState& state);

struct PinkSightings {
  const PinkBearings& bearings;  // of one frame
  const PoseState& pose;         // of the robot
  const body::LandmarkMap& landmarks;
};

// Maps the patches of one frame; what is not used is counted.
void mapPatches(const PinkSightings& seen, const PinkMapParams& params, PinkLandmarks& map,
                GpsCounts& counts);

}  // namespace kelpie::gps
