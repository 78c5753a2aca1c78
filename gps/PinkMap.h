// SPDX-License-Identifier: Apache-2.0
// Where on the outer wall the pink patches hang (thesis 2004 section 4.1.2): the ray from the
// robot's pose through the patch meets the wall. Only as good as the pose and the measured wall.
#pragma once

#include <optional>

#include "gps/GpsParams.h"
#include "gps/GpsState.h"
#include "robot/core/Percepts.h"

namespace kelpie::gps {

struct Ray {
  Point2<Field> from;
  Point2<Field> along;  // unit vector
};
Ray rayOf(const Pose2& pose, Angle heading);

// The nearest place ahead at which the ray meets the wall; the wall need not be a rectangle.
std::optional<Point2<Field>> meetWall(const Ray& ray, const std::array<double, 8>& wall);

// A patch at that elevation can hang on a wall that far away: neither lower than minElevation nor
// higher than maxAbove over the camera there, which is an angle that falls with the distance.
bool mayHangOnWall(Angle elevation, double distance, const PinkParams& params);

// The ray passes no beacon within beaconClearance; those behind the robot do not count.
bool clearOfBeacons(const Ray& ray, const body::FieldDescription& field, TeamColour team,
                    double clearance);

// Everything in the percept that is used is finite and its variance positive.
bool usable(const PinkPercept& percept);

// Adds a sighting of weight 1, or merges it into the nearest entry within the radius, by weight.
// False when the map is full.
bool addToMap(Point2<Field> place, double mergeRadius, PinkLandmarks& map);

// Takes one from every weight each `forgetSeconds` and drops what has none left.
void forget(double seconds, const PinkParams& params, PinkState& state);

// Maps the patches of one frame; what is not used is counted.
void mapPatches(const FixedVector<PinkPercept, 8>& patches, TeamColour team,
                const GpsParams& params, GpsState& state);

}  // namespace kelpie::gps
