// SPDX-License-Identifier: Apache-2.0
// Tunables of what is made of field lines beyond one frame: the map of a standing robot (thesis
// 2004 section 3.2.4) and the search over the field (thesis 2004 section 4.1.4).
#pragma once

#include <cstdint>

#include "robot/core/Angle.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::gps {

struct LineMapParams {
  bool use = true;
  double radius = 2.5;  // cm, of a line point's merge region; checklist U21: 4 cm + 4 %, 3 deg,
  double radiusShare = 0.025;      // of its distance, more; leaves 34 points at some places, not 64
  Angle angle = Angle::deg(1.5);   // to either side of it
  double carpetRadius = 8.0;       // cm, of a point on green
  double carpetShare = 0.08;       // of its distance, more
  double decay = 1.0;              // s in which every point loses a count of 1 (checklist U12)
  double maxCount = 20.0;          // sightings that count in a point
  std::uint32_t maxCarpet = 32;    // of the 128 points
  std::uint32_t matched = 64;      // of its points on lines and border, spread evenly
  std::uint32_t maxRefused = 15;   // frames in a row that match nothing; then it is cleared
  double maxUnmatchedShare = 0.6;  // of points that match none; above, the robot was carried
  double fullWeightCount = 3.0;    // sightings from which a point has its full weight

  template <int = 0>
  static constexpr auto fields() {
    using P = LineMapParams;
    return fieldList(
        field("use", &P::use), field("radius", &P::radius, "cm", 0, 100),
        field("radiusShare", &P::radiusShare, "", 0, 1), field("angle", &P::angle, "rad", 0, 90),
        field("carpetRadius", &P::carpetRadius, "cm", 0, 100),
        field("carpetShare", &P::carpetShare, "", 0, 1), field("decay", &P::decay, "s", 0.01, 1000),
        field("maxCount", &P::maxCount, "", 1, 1e4), field("maxCarpet", &P::maxCarpet, "", 0, 128),
        field("matched", &P::matched, "", 8, 128), field("maxRefused", &P::maxRefused, "", 1, 1000),
        field("maxUnmatchedShare", &P::maxUnmatchedShare, "", 0, 1),
        field("fullWeightCount", &P::fullWeightCount, "", 1, 100));
  }
};

struct LinePoseSearchParams {
  bool use = true;
  std::uint32_t columns = 4;       // of starts across the field
  std::uint32_t rows = 3;          // along the own half; the other looks the same
  std::uint32_t turns = 12;        // headings at each place
  std::uint32_t startsAFrame = 2;  // 150 k instructions of a PC
  std::uint32_t minPoints = 64;    // of lines and border in the map: what a pan shows
  double patience = 5.0;           // s of standing after which 16 are enough
  std::uint32_t points = 32;       // matched from each start
  double coarseShare = 0.0625;     // of LineUpdateParams::sharpness, for the steps from a start
  double minMatch = 0.6;
  double apart = 15.0;     // cm, and degrees: nearer poses are the same
  double priorSd = 250.0;  // cm, of a found pose where the lines say nothing
  Angle priorHeadingSd = Angle::deg(150.0);

  template <int = 0>
  static constexpr auto fields() {
    using P = LinePoseSearchParams;
    return fieldList(
        field("use", &P::use), field("columns", &P::columns, "", 1, 40),
        field("rows", &P::rows, "", 1, 40), field("turns", &P::turns, "", 1, 72),
        field("startsAFrame", &P::startsAFrame, "", 1, 1000),
        field("minPoints", &P::minPoints, "", 8, 128),
        field("patience", &P::patience, "s", 0, 1000), field("points", &P::points, "", 8, 128),
        field("coarseShare", &P::coarseShare, "", 0.001, 1),
        field("minMatch", &P::minMatch, "", 0, 1), field("apart", &P::apart, "cm", 0.1, 100),
        field("priorSd", &P::priorSd, "cm", 10, 1e4),
        field("priorHeadingSd", &P::priorHeadingSd, "rad", 10, 180));
  }
};

}  // namespace kelpie::gps
