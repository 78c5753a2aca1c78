// SPDX-License-Identifier: Apache-2.0
// What can be tuned in the filter of the pose. Defaults come from thesis 2004 chapter 2 where it
// states numbers, else from a working filter (facts-2005 section 5.1), else they are ours.
#pragma once

#include <cstdint>

#include "robot/core/types/Geometry.h"

namespace kelpie::gps {

// A known start. Without one the first landmarks seen give the modes.
struct InitialPose {
  bool present = false;
  Pose2 pose;
  double positionSd = 20.0;
  Angle headingSd = Angle::deg(10.0);

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("present", &InitialPose::present), field("pose", &InitialPose::pose),
                     field("positionSd", &InitialPose::positionSd, "cm", 0.1, 1000),
                     field("headingSd", &InitialPose::headingSd, "rad", 0.1, 180));
  }
};

// Noise of the odometry. Variances grow with the way walked, so that they do not depend on the
// frame rate: 0.1 cm2 per cm is 1.4 cm after 20 cm. Eight times as much costs 0.4 of 1.2 cm in the
// nominal world (`kelpie evaluate localise`); NoiseScale finds what a robot has of it.
struct MotionNoise {
  double alongPerCm = 0.1;          // cm2 along the walking direction per cm walked
  double acrossPerCm = 0.0625;      // cm2 across it per cm walked
  double turnPerRad = 0.75e-3;      // rad2 per rad turned
  double turnPerCm = 0.625e-5;      // rad2 per cm walked
  double positionPerRad = 0.5;      // cm2 per rad turned
  double positionPerSecond = 0.25;  // cm2/s always: pushes
  double turnPerSecond = 1.9e-5;    // rad2/s always

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("alongPerCm", &MotionNoise::alongPerCm, "cm", 0, 100),
                     field("acrossPerCm", &MotionNoise::acrossPerCm, "cm", 0, 100),
                     field("turnPerRad", &MotionNoise::turnPerRad, "rad", 0, 10),
                     field("turnPerCm", &MotionNoise::turnPerCm, "rad2/cm", 0, 1),
                     field("positionPerRad", &MotionNoise::positionPerRad, "cm2/rad", 0, 1000),
                     field("positionPerSecond", &MotionNoise::positionPerSecond, "cm2/s", 0, 1e4),
                     field("turnPerSecond", &MotionNoise::turnPerSecond, "rad2/s", 0, 10));
  }
};

// Which landmark sightings are believed, and how much (thesis 2004 section 2.2.2).
struct LandmarkGates {
  double goalMin = 70.0;                  // nearer goals are not used at all
  double goalMaxDistance = 250.0;         // farther: heading only
  double beaconMaxDistance = 450.0;       // farther: heading only
  double maxDistanceVariance = 2500.0;    // cm2; above: heading only
  Angle maxHeadingSd = Angle::deg(15.0);  // above: refused
  double goalLineShare = 0.15;            // no goal seen from that near its own line
  double distanceVarianceFactor = 2.0;    // errors of one landmark repeat between frames
  double headingVarianceFactor = 2.0;     // so do these
  double minDistanceSd = 4.0;             // cm
  Angle minHeadingSd = Angle::deg(1.5);   // sway of the walking body

  template <int = 0>
  static constexpr auto fields() {
    using G = LandmarkGates;
    return fieldList(field("goalMin", &G::goalMin, "cm", 0, 1000),
                     field("goalMaxDistance", &G::goalMaxDistance, "cm", 0, 2000),
                     field("beaconMaxDistance", &G::beaconMaxDistance, "cm", 0, 2000),
                     field("maxDistanceVariance", &G::maxDistanceVariance, "cm2", 0, 1e6),
                     field("maxHeadingSd", &G::maxHeadingSd, "rad", 0, 90),
                     field("goalLineShare", &G::goalLineShare, "", 0, 1),
                     field("distanceVarianceFactor", &G::distanceVarianceFactor, "", 0.1, 100),
                     field("headingVarianceFactor", &G::headingVarianceFactor, "", 0.1, 100),
                     field("minDistanceSd", &G::minDistanceSd, "cm", 0.1, 100),
                     field("minHeadingSd", &G::minHeadingSd, "rad", 0.1, 45));
  }
};

// How hypotheses live and die. A sighting that a mode did not predict is treated by method 3 of
// thesis 2004 section 2.2.3: an uncorrected copy of every mode, and a wide mode each time. Without
// the wide mode it is method 2. Beginning again is ours.
struct ModeParams {
  double outlierWeight = 1e-2;  // of the copy that is not updated: a false sighting's odds
  // The same where the last sighting was false and other landmarks were not: a goal behind a robot
  // looks shifted in every frame, and after eight a mode elsewhere was the best. Where no landmark
  // fits, the robot was carried.
  double repeatedOutlierWeight = 0.3;
  double sightingFade = 0.3;  // s in which a record of sightings falls to 1/e
  // Of the mode added at the centre before each update; 0: none. 1e-12 costs robots among others
  // 0.4 of 4.7 cm: half hidden beacons win by it (docs/decisions.md).
  double wideWeight = 1e-16;
  double widePositionSd = 250.0;  // cm
  Angle wideHeadingSd = Angle::deg(150.0);
  double mergeDistance = 5.0;      // cm, and degrees for the heading
  double mergeCovariance = 200.0;  // cm2, and deg2 for the heading
  double seedSpacing = 30.0;       // deg between the poses tried around the first landmark
  double explainedShare = 0.1;     // of all weight in corrected modes, at least; else unexplained
  std::uint32_t maxUnexplained = 10;  // in a row; then the next landmark gives new modes; 0: never

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("outlierWeight", &ModeParams::outlierWeight, "", 0, 1),
                     field("repeatedOutlierWeight", &ModeParams::repeatedOutlierWeight, "", 0, 1),
                     field("sightingFade", &ModeParams::sightingFade, "s", 0.01, 100),
                     field("wideWeight", &ModeParams::wideWeight, "", 0, 1),
                     field("widePositionSd", &ModeParams::widePositionSd, "cm", 10, 1e4),
                     field("wideHeadingSd", &ModeParams::wideHeadingSd, "rad", 10, 180),
                     field("mergeDistance", &ModeParams::mergeDistance, "cm", 0, 100),
                     field("mergeCovariance", &ModeParams::mergeCovariance, "cm2", 0, 1e5),
                     field("seedSpacing", &ModeParams::seedSpacing, "deg", 20, 180),
                     field("explainedShare", &ModeParams::explainedShare, "", 0, 1),
                     field("maxUnexplained", &ModeParams::maxUnexplained, "", 0, 10000));
  }
};

}  // namespace kelpie::gps
