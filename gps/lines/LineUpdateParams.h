// SPDX-License-Identifier: Apache-2.0
// Tunables of the update by field lines (thesis 2004 sections 3.2 and 3.3).
#pragma once

#include <cstdint>

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::gps {

// What the field lines do to the pose (checklist K06): nothing; judge the modes, whose weights they
// change and whose poses they leave (2006); correct the modes' poses (2004) and find lost ones.
enum class LineUse : std::uint8_t { off, sanity, position };

struct LineUpdateParams {
  LineUse use = LineUse::position;
  std::uint32_t minPoints = 8;  // of lines and border in a frame; facts-2005 section 5.2 has 8
  // Of lines that are used, and of the border, spread evenly. 40 cost half more and are no better:
  // 1.26 cm for 1.23 (`kelpie evaluate localise`).
  std::uint32_t maxPoints = 24;
  double sharpness = 0.004;    // 1/cm2, S of thesis 2004 equation 3.2: a match of 0.5 at 16 cm
  double coarseShare = 0.125;  // of the sharpness, for the first steps of an unsure mode
  double coarseAbove = 12.0;   // cm, sd of a mode from which these are made
  Angle coarseAboveTilt = Angle::deg(1.6);  // or of its tilt
  std::uint32_t maxSteps = 4;               // of the maximiser; five are no better on legs
  double farStep = 20.0;                    // cm, most of one step
  Angle farTurn = Angle::deg(15);           // the same for the heading
  double pointSd = 2.7;                     // cm, of one point on the ground
  double correlation = 6.0;                 // how many points of how many frames share their error
  double floorSd = 1.0;                     // cm, of a pose from lines, whatever their number
  Angle floorHeadingSd = Angle::deg(0.4);
  double match = 0.5;       // least match with a still head is match + matchStill (thesis 2004
  double matchStill = 0.3;  // equation 3.22) and falls with the head's speed
  double headSpeed = 50.0;  // 1/rad a frame, of thesis 2004 equations 3.22 and 3.23
  double offField = 0.02;   // 1/cm2, of thesis 2004 equation 3.21
  // Of the copy that the lines do not correct: of a body that nothing shakes, and of one that is
  // shaken by 100 cm/s2 as on walking legs, where a sway shifts all points together. With 0.05
  // there the pose is 0.3 cm farther off (`kelpie evaluate localise`); with 0.3 where nothing
  // shakes some starts by lines alone are lost (`kelpie evaluate mode-sampling`).
  double outlierWeight = 0.05;
  double shakenOutlierWeight = 0.3;
  // Of a mode whose lines match nothing. A correction multiplies the true mode's by 0.35 on
  // average; with 0.5 here a wrong one outgrew it within 4 s of one landmark in view.
  double refusedWeight = 0.15;
  double minWeight = 0.05;  // of the heaviest; lighter modes are not fitted
  // So many are fitted. Three in eight steps took 628 k instructions at most, two in five 372 k.
  std::uint32_t maxModes = 2;
  double maxSd = 60.0;  // cm; wider modes say nothing about which line is seen
  Angle maxHeadingSd = Angle::deg(30);

  template <int = 0>
  static constexpr auto fields() {
    using P = LineUpdateParams;
    return fieldList(
        field("use", &P::use, "", 0, 2), field("minPoints", &P::minPoints, "", 1, 256),
        field("maxPoints", &P::maxPoints, "", 4, 64),
        field("sharpness", &P::sharpness, "1/cm2", 1e-5, 1),
        field("coarseShare", &P::coarseShare, "", 0.001, 1),
        field("coarseAbove", &P::coarseAbove, "cm", 0, 1000),
        field("coarseAboveTilt", &P::coarseAboveTilt, "rad", 0, 90),
        field("maxSteps", &P::maxSteps, "", 1, 100), field("farStep", &P::farStep, "cm", 0.1, 200),
        field("farTurn", &P::farTurn, "rad", 0.1, 90),
        field("pointSd", &P::pointSd, "cm", 0.1, 100),
        field("correlation", &P::correlation, "", 0.1, 1000),
        field("floorSd", &P::floorSd, "cm", 0, 100),
        field("floorHeadingSd", &P::floorHeadingSd, "rad", 0, 45),
        field("match", &P::match, "", 0, 1), field("matchStill", &P::matchStill, "", 0, 1),
        field("headSpeed", &P::headSpeed, "", 0, 1000),
        field("offField", &P::offField, "1/cm2", 0, 1),
        field("outlierWeight", &P::outlierWeight, "", 0, 1),
        field("shakenOutlierWeight", &P::shakenOutlierWeight, "", 0, 1),
        field("refusedWeight", &P::refusedWeight, "", 0, 1),
        field("minWeight", &P::minWeight, "", 0, 1), field("maxModes", &P::maxModes, "", 1, 8),
        field("maxSd", &P::maxSd, "cm", 1, 1000),
        field("maxHeadingSd", &P::maxHeadingSd, "rad", 1, 180));
  }
};

}  // namespace kelpie::gps
