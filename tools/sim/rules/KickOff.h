// SPDX-License-Identifier: Apache-2.0
// Where robots may stand at a kick-off, when all do, and where a hand puts those that do not: on
// the field in the own half, forwards out of the own goal box, and out of the centre circle who
// has not the kick-off. A robot's place is its neck base; of the circle, its whole stripe.
#pragma once

#include <array>

#include "tools/sim/rules/MatchScene.h"

namespace kelpie::sim {

bool inOwnGoalBox(const body::FieldDescription& field, TeamColour team, Point2<Field> p);

bool standsLegally(const body::FieldDescription& field, const ScenePlayer& player,
                   TeamColour kickOff);

// The team's place for that number, farther back for those who wait for the other team's kick-off;
// where somebody stands there, a team mate's, and if all are taken beside its own.
Pose2 manualPlace(const body::FieldDescription& field, const MatchScene& scene, std::size_t player,
                  TeamColour kickOff);

struct KickOffIn {
  const MatchScene& scene;
  TeamColour kickOff = TeamColour::red;
};

struct KickOffState {
  bool begun = false;
  TimeUs since;  // all stand legally and still
  FixedVector<Pose2, kMaxRobots> places;
};

// Whether all have stood legally and still for readyStill. Standing robots sway: still is within
// 2 cm and 5 degrees.
bool step(const KickOffIn& in, const body::FieldDescription& field, KickOffState& state);

}  // namespace kelpie::sim
