// SPDX-License-Identifier: Apache-2.0
// Goals, balls that leave the field, and where a ball is put back: by the side where it left, on
// the line throwInFromSide inside that side line; what left over a goal line, at that line's end,
// throwInFromEnd from the goal line (body::throwInPlace). Who touched it last does not move it.
#pragma once

#include <optional>

#include "tools/sim/rules/MatchScene.h"

namespace kelpie::sim {

// The whole ball is behind a goal line and between the posts: which team scores.
std::optional<TeamColour> goalFor(const body::FieldDescription& field, Point2<Field> ball);
// The whole ball is beyond a line and not in a goal.
bool ballOut(const body::FieldDescription& field, Point2<Field> ball);
// In words: over which line.
const char* outOver(const body::FieldDescription& field, Point2<Field> ball);

// The throw-in place, or the nearest to it up-field that nobody stands on.
Point2<Field> throwIn(const body::FieldDescription& field, const MatchScene& scene);
// For a ball that goes nowhere: the nearest throw-in place, and if it lies there already, the one
// at the other side.
Point2<Field> dropIn(const body::FieldDescription& field, const MatchScene& scene);

}  // namespace kelpie::sim
