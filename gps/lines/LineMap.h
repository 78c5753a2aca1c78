// SPDX-License-Identifier: Apache-2.0
// The map of a standing robot: points of successive frames in the robot's frame, those near
// another of their kind merged (thesis 2004 section 3.2.4). Full pans show corners that no single
// image shows, and the errors of single images average out. Void as soon as the robot moves.
//
// The map is matched in every frame, but every sighting counts once: an update's information is
// scaled by the sightings since the last one over the points matched
// (`SeenLines::newEvidenceShare`).
#pragma once

#include "gps/lines/LineFit.h"
#include "gps/lines/LineState.h"
#include "gps/lines/LinesParams.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie::gps {

// No odometry, no walk requested, no special motion.
bool standing(const FrameInput& input);

// Thesis 2004 equations 3.18 and 3.19 for either of the two; the latter with its numerator squared
// (checklist H10).
bool inOneRegion(const MapPoint& a, const MapPoint& b, const LineMapParams& params);

// Merges a point, and the merged one again, until it lies in no other's region; a full map takes no
// more. Points that are not finite, beyond 10 m or without weight are left out. Returns whether it
// found a region to lie in.
bool add(const LinePoint& point, const LineMapParams& params, LineMap& map);

// One frame: evenly thinned points, then the decay. A frame of a moving robot clears the map.
void stepMap(const FrameInput& input, const FixedVector<LinePoint, 256>& points,
             const LinesParams& params, LineMap& map);

// The map's points as those of one frame, `max` of lines at most; `newEvidenceShare` is set.
SeenLines seenLines(const LineMap& map, std::size_t max, const LineMapParams& params);

std::size_t countOf(const LineMap& map, LinePointKind kind);
std::size_t countOfWhite(const LineMap& map);  // points of lines and of the border

}  // namespace kelpie::gps
