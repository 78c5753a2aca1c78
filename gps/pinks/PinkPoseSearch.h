// SPDX-License-Identifier: Apache-2.0
// Where on the whole field a survey fits: the best poses of a grid are refined by their lines, and
// the result counts when it outweighs all others (thesis 2004 section 4.1.4, which never ran).
// Lines alone cannot tell a pose from its twin; the mapped pinks decide.
#pragma once

#include "gps/lines/FieldFeatures.h"
#include "gps/pinks/PinkContext.h"
#include "gps/pinks/PinkState.h"
#include "gps/pinks/Survey.h"

namespace kelpie::gps {

// How well the survey's line points lie on painted lines when it began at `start`, 0 to 1.
double surveyMatch(const SeenLines& lines, const Pose2& start, const FieldFeatures& field,
                   double sharpness);

// Log likelihood of the survey's bearings: each points to one of the mapped pinks, equally likely,
// or to something else, and surely to something else where it is too high or low for the wall.
double bearingScore(const Survey& survey, const Pose2& start, const PinkLandmarks& pinks, Angle sd,
                    const PinkMapParams& params);

// One frame's share of the search; true when it came to an end.
bool stepPinkPoseSearch(const Survey& survey, const PinkLandmarks& pinks,
                        const PinkContext& context, PoseSearch& search);

// The best pose's share of the likelihood of all that were found; 0 for none.
double sureness(const FoundPoses& found);

}  // namespace kelpie::gps
