// SPDX-License-Identifier: Apache-2.0
// Tunables of the search for other robots. An ERS-7 is about 28 cm long, 18 wide and 28 high with
// its head up; its uniform's patches are 8 to 22 cm above the ground.
#pragma once

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::vision {

struct RobotFinderParams {
  double minSamples = 2;              // lattice samples of a patch
  double minOwnShare = 0.3;           // of its colour among those it may be confused with
  double sureCarpetBehind = 5;        // px: with so much carpet behind it clothes are ruled out
  double doubtfulForeignShare = 0.5;  // most of other colours on a ring round a patch, then
  double cleanOwnShare = 0.8;         // of a patch that is believed without carpet behind it
  double cleanForeignShare = 0.2;
  Angle maxElevation = Angle::deg(14);  // a patch 20 cm high seen from 12 cm at 35 cm: 13 deg
  double minInsideFieldEdge = 0.6;      // px, of the foot from the field edge
  double minCarpetBeyond = 5;       // cm from a carpet foot to the edge: players are inside lines
  double minPatchWidth = 1.2;       // cm
  double minCutPatch = 2;           // cm, height of a patch whose robot shows no feet
  double maxPatchWidth = 15;        // cm
  double maxPatchHeight = 11;       // cm
  double maxTall = 3.5;             // height to width of a patch: trouser legs are taller
  double minHeight = 6;             // cm, of a patch's middle above the ground
  double maxHeight = 25;            // cm
  double minShell = 0.05;           // share of white and grey round a patch
  double fewSamples = 3;            // lattice samples of a patch that may be a speck
  double minShellOfFew = 0.1;       // minShell of such
  double maxSpeckDistance = 60;     // cm, of a patch of so few samples
  double speckCarpetBehind = 6;     // px: before so much carpet a speck may be nearer than that
  double maxLogOddsAgainst = -0.7;  // log odds, see RobotFacts.h
  double partSamples = 20;          // of a patch that only tells its robot's distance
  double maxBorderRatio = 2.4;      // of the way to the ground that the border shows, feet cut
  double patchHeight = 12;          // cm, assumed when the image border cuts the feet
  double patchSize = 5.5;           // cm, upright; the same
  double maxCutDistance = 70;       // cm, for such a robot: farther ones show their feet
  double maxDoubtfulCutDistance = 50;  // with other colours round its patch
  double reach = 9;                    // cm beside a patch where legs are looked for
  double maxGap = 13;                  // cm between two patches of one robot
  double maxLength = 30;               // cm, of all patches of one robot
  double maxDepthRatio = 2;            // of the distances of two patches of one robot
  double minTeamRatio = 2;  // of samples, for one team's patches to rule out those of the other
  double depth = 7;         // cm from the nearest leg to the body's middle
  double maxDistance = 240;
  double edgeSd = 0.7;                // px, of the foot
  Angle directionSd = Angle::deg(1);  // camera against ground, while walking
  double headingSd = 4;               // cm across, of the middle of the patches

  template <int = 0>
  static constexpr auto fields() {
    using P = RobotFinderParams;
    return fieldList(
        field("minSamples", &P::minSamples, "", 1, 100),
        field("minOwnShare", &P::minOwnShare, "", 0, 1),
        field("sureCarpetBehind", &P::sureCarpetBehind, "px", -10, 50),
        field("doubtfulForeignShare", &P::doubtfulForeignShare, "", 0, 1),
        field("cleanOwnShare", &P::cleanOwnShare, "", 0, 1),
        field("cleanForeignShare", &P::cleanForeignShare, "", 0, 1),
        field("maxElevation", &P::maxElevation, "rad", -90, 90),
        field("minCarpetBeyond", &P::minCarpetBeyond, "cm", 0, 100),
        field("minInsideFieldEdge", &P::minInsideFieldEdge, "px", -160, 160),
        field("minPatchWidth", &P::minPatchWidth, "cm", 0, 100),
        field("minCutPatch", &P::minCutPatch, "cm", 0, 100),
        field("maxPatchWidth", &P::maxPatchWidth, "cm", 1, 100),
        field("maxTall", &P::maxTall, "", 0.1, 20),
        field("maxPatchHeight", &P::maxPatchHeight, "cm", 1, 100),
        field("minHeight", &P::minHeight, "cm", -20, 50),
        field("maxHeight", &P::maxHeight, "cm", 0, 100), field("minShell", &P::minShell, "", 0, 1),
        field("fewSamples", &P::fewSamples, "", 0, 1000),
        field("minShellOfFew", &P::minShellOfFew, "", 0, 1),
        field("maxSpeckDistance", &P::maxSpeckDistance, "cm", 0, 500),
        field("speckCarpetBehind", &P::speckCarpetBehind, "px", -10, 50),
        field("maxLogOddsAgainst", &P::maxLogOddsAgainst, "", -20, 20),
        field("partSamples", &P::partSamples, "", 1, 1000),
        field("maxBorderRatio", &P::maxBorderRatio, "", 1, 100),
        field("patchSize", &P::patchSize, "cm", 1, 50),
        field("patchHeight", &P::patchHeight, "cm", 1, 50),
        field("maxCutDistance", &P::maxCutDistance, "cm", 0, 500),
        field("maxDoubtfulCutDistance", &P::maxDoubtfulCutDistance, "cm", 0, 500),
        field("reach", &P::reach, "cm", 0, 50), field("maxGap", &P::maxGap, "cm", 0, 50),
        field("maxLength", &P::maxLength, "cm", 5, 100),
        field("minTeamRatio", &P::minTeamRatio, "", 1, 100),
        field("maxDepthRatio", &P::maxDepthRatio, "", 1, 10),
        field("depth", &P::depth, "cm", 0, 30),
        field("maxDistance", &P::maxDistance, "cm", 50, 1000),
        field("edgeSd", &P::edgeSd, "px", 0.01, 5),
        field("directionSd", &P::directionSd, "rad", 0.05, 20),
        field("headingSd", &P::headingSd, "cm", 0.1, 20));
  }
};

}  // namespace kelpie::vision
