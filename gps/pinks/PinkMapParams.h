// SPDX-License-Identifier: Apache-2.0
// Tunables of the 2004 localisation challenge (thesis 2004 section 4.1): the map of pink patches on
// the outer wall, the update by them, and the search for the pose of a robot that was carried away.
#pragma once

#include <array>
#include <cstdint>

#include "robot/body/FieldDescription.h"
#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::gps {

// The search over the whole field by what a standing robot has seen around it (thesis 2004 section
// 4.1.4, "one time edge localise"), spread over frames so that no frame is dropped.
struct PinkPoseSearchParams {
  double surveySeconds = 5.0;  // of looking round before the first search (thesis 2004 4.1.4)
  double againSeconds = 2.5;   // more of it before the next, while no pose is sure
  double keepSeconds = 25.0;   // of looking round, once around and a little; then it is restarted
  double cell = 8.0;           // cm, one line point is kept in each
  double farthest = 220.0;     // cm of a line point that is kept
  Angle sameBearing = Angle::deg(5);
  double sameOrigin = 15.0;               // cm
  std::uint32_t minBearings = 2;          // fewer cannot tell a pose from its twin
  double step = 20.0;                     // cm between the places tried
  Angle turnStep = Angle::deg(10);        // between the headings tried
  std::uint32_t startsPerFrame = 720;     // poses tried in a frame: 27 frames for a 2006 field
  std::uint32_t refinedPerFrame = 2;      // of the best ones
  double coarseSharpness = 0.0015;        // 1/cm2: a match of 0.5 at 26 cm
  double fineSharpness = 0.015;           // 1/cm2: at 8 cm
  Angle coarseBearingSd = Angle::deg(8);  // the grid is that coarse
  Angle bearingSd = Angle::deg(3);
  double missed = 0.02;        // odds of a bearing to something that is not in the map
  double lineScore = 60.0;     // nats from no line point on a line to all of them
  std::uint32_t patience = 9;  // searches, 4 s each, until a likely pose is enough
  double likelyShare = 0.6;
  double sureShare = 0.9;  // of the best pose among all found
  double placeSd = 12.0;   // cm, of the mode made of it
  Angle headingSd = Angle::deg(4);

  template <int = 0>
  static constexpr auto fields() {
    using P = PinkPoseSearchParams;
    return fieldList(
        field("surveySeconds", &P::surveySeconds, "s", 0, 100),
        field("againSeconds", &P::againSeconds, "s", 0, 100),
        field("keepSeconds", &P::keepSeconds, "s", 1, 1000), field("cell", &P::cell, "cm", 1, 100),
        field("farthest", &P::farthest, "cm", 50, 500),
        field("sameBearing", &P::sameBearing, "rad", 0.1, 45),
        field("sameOrigin", &P::sameOrigin, "cm", 0, 100),
        field("minBearings", &P::minBearings, "", 0, 24), field("step", &P::step, "cm", 5, 100),
        field("turnStep", &P::turnStep, "rad", 2, 90),
        field("startsPerFrame", &P::startsPerFrame, "", 1, 1e6),
        field("refinedPerFrame", &P::refinedPerFrame, "", 1, 100),
        field("coarseSharpness", &P::coarseSharpness, "1/cm2", 1e-5, 1),
        field("fineSharpness", &P::fineSharpness, "1/cm2", 1e-5, 1),
        field("coarseBearingSd", &P::coarseBearingSd, "rad", 0.1, 45),
        field("bearingSd", &P::bearingSd, "rad", 0.1, 45), field("missed", &P::missed, "", 1e-6, 1),
        field("lineScore", &P::lineScore, "", 0, 1000), field("sureShare", &P::sureShare, "", 0, 1),
        field("patience", &P::patience, "", 0, 1e6),
        field("likelyShare", &P::likelyShare, "", 0, 1),
        field("placeSd", &P::placeSd, "cm", 1, 200),
        field("headingSd", &P::headingSd, "rad", 0.1, 90));
  }
};

constexpr double kWallBeyondCarpet = 15.0;  // cm

struct PinkMapParams {
  // x, y of the outer wall's corners as measured before the challenge, going round; it need not be
  // a rectangle. By default a little beyond the carpet; the agent's default is of its own field.
  std::array<double, 8> wall = body::wallAround({}, kWallBeyondCarpet);
  // Cm above the ground where a patch's middle would be if it hung on the wall. A wall of 30 cm
  // hides what is lower behind it, so that of spectators only what is higher is seen. Checklist U13
  // proposes elevations from -2 deg to 3000 deg / d: 50 cm above the camera.
  double minHeight = -5.0;
  double maxHeight = 29.0;
  // Cm from the ray to a beacon. The thesis' 25 left pinks unmapped behind beacons (0.83 found),
  // and then, the beacons gone, the robot took them for others; with 10 all were found, without
  // ghosts.
  double beaconClearance = 10.0;
  double mergeRadius = 25.0;    // cm
  double glanceReach = 60.0;    // cm between a patch and where a ray along its wall meets the wall
  double glanceLateral = 12.0;  // cm from the patch to that ray
  double forgetSeconds = 4.0;   // every so often each weight falls by one
  double maxPositionSd = 8.0;   // cm; a robot that knows its place less does not map
  Angle maxHeadingSd = Angle::deg(3);
  double minWeight = 3.0;                // of a mapped patch that the robot localises by
  double mapSd = 6.0;                    // cm, of a mapped patch
  Angle minBearingSd = Angle::deg(1.5);  // of one bearing: sway, and errors that repeat
  std::uint32_t maxPatches = 8;          // of a frame, largest first; the thesis uses one
  std::uint32_t maxUnexplained = 60;     // sightings in a row that fit no mode: the pose is lost
  PinkPoseSearchParams search;

  template <int = 0>
  static constexpr auto fields() {
    using P = PinkMapParams;
    return fieldList(
        field("wall", &P::wall, "cm", -1000, 2000),
        field("minHeight", &P::minHeight, "cm", -1000, 1000),
        field("maxHeight", &P::maxHeight, "cm", -1000, 1000),
        field("beaconClearance", &P::beaconClearance, "cm", 0, 200),
        field("mergeRadius", &P::mergeRadius, "cm", 0, 200),
        field("glanceReach", &P::glanceReach, "cm", 0, 500),
        field("glanceLateral", &P::glanceLateral, "cm", 0, 200),
        field("forgetSeconds", &P::forgetSeconds, "s", 0.1, 1000),
        field("maxPositionSd", &P::maxPositionSd, "cm", 0.1, 1000),
        field("maxHeadingSd", &P::maxHeadingSd, "rad", 0.1, 180),
        field("minWeight", &P::minWeight, "", 0, 1e6), field("mapSd", &P::mapSd, "cm", 0, 100),
        field("minBearingSd", &P::minBearingSd, "rad", 0.1, 45),
        field("maxPatches", &P::maxPatches, "", 1, 8),
        field("maxUnexplained", &P::maxUnexplained, "", 1, 10000), field("search", &P::search));
  }
};

}  // namespace kelpie::gps
