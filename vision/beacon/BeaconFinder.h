// SPDX-License-Identifier: Apache-2.0
// Beacons: a pink band with a blue or yellow one right above or below, over white. Sought upwards
// from the white (BeaconFeet) and, in case something hides that, from the middle of every pink blob
// (BeaconCandidate). What every beacon passes is checked; the rest are facts, judged as a whole
// (BeaconFacts).
#pragma once

#include "robot/core/types/Percepts.h"
#include "vision/Scene.h"
#include "vision/beacon/BeaconCandidate.h"
#include "vision/beacon/BeaconFinderParams.h"
#include "vision/beacon/JudgedBeacon.h"

namespace kelpie::vision {

// The checks: true = keep.
bool beaconHasPartner(const BeaconCandidate& c);
bool beaconIsLarge(const BeaconCandidate& c, const BeaconFinderParams& p);
bool beaconReachesHorizon(const Scene& scene, const BeaconCandidate& c,
                          const BeaconFinderParams& p);
// A robot may hide the white below it, not what is carpet.
bool beaconHasNoCarpetBelow(const Scene& scene, const BeaconCandidate& c);
bool beaconIsNear(const BeaconCandidate& c, const BeaconFinderParams& p);
bool beaconHeightFitsSize(const Scene& scene, const BeaconCandidate& c,
                          const BeaconFinderParams& p);

void findBeacons(const Scene& scene, const BeaconFinderParams& params, VisionCounts& counts,
                 Landmarks& landmarks, JudgedBeacons& judged);

}  // namespace kelpie::vision
