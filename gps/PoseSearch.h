// SPDX-License-Identifier: Apache-2.0
// Where on the whole field a survey fits: a grid of poses is tried, some each frame, the best are
// refined by their lines, and the result counts when it outweighs all others (thesis 2004 section
// 4.1.4, which never ran). Lines alone fit a pose and its twin alike; the mapped pinks decide.
#pragma once

#include "gps/FieldFeatures.h"
#include "gps/GpsParams.h"
#include "gps/GpsState.h"
#include "gps/Survey.h"

namespace kelpie::gps {

// How well the survey's line points lie on painted lines when it began at `start`, 0 to 1.
double surveyMatch(const SeenLines& lines, const Pose2& start, const FieldFeatures& field,
                   double sharpness);

// Log likelihood of the survey's bearings: each to one of the mapped pinks, equally likely, or to
// none of them; only to none where it would be too high or too low for the wall.
double bearingScore(const Survey& survey, const Pose2& start, const PinkLandmarks& pinks, Angle sd,
                    const PinkParams& params);

// One frame's share of the search. True when it came to an end; then `candidates` are sorted, best
// first.
bool searchOn(const Survey& survey, const PinkLandmarks& pinks, const FieldFeatures& field,
              const GpsParams& params, Search& search);

// The best candidate's share of the likelihood of all that are elsewhere; 0 for none.
double sureness(const Search& search);

}  // namespace kelpie::gps
