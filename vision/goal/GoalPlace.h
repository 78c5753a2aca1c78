// SPDX-License-Identifier: Apache-2.0
// Whether a goal stands where the field has one: its back wall on a field edge, half a carpet
// from its corners, and at its place from the beacons in the same image. Weak where the image shows
// one edge and no beacon: clothes may stand anywhere along it.
#pragma once

#include "vision/goal/GoalFacts.h"
#include "vision/goal/GoalShape.h"

namespace kelpie::vision {

// Sets what the image tells of the goal's place; the others stay 0.
void addPlace(const Scene& scene, const GoalCandidate& c, const GoalShape& shape,
              const Landmarks& beacons, GoalFacts& facts);

}  // namespace kelpie::vision
