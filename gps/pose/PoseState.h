// SPDX-License-Identifier: Apache-2.0
// What the filter of the pose remembers between frames: the modes, and how walking goes. Plain
// data.
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/FixedVector.h"
#include "robot/core/types/ObjectPercepts.h"
#include "robot/core/types/WorldModel.h"

namespace kelpie::gps {

// Each of the modes, the wide one and one of a crossing may be split in two.
constexpr std::size_t kWorkModes = 2 * (kMaxModes + 2);
using Modes = FixedVector<PoseMode, kWorkModes>;

// How hard walking has been recently.
struct StuckState {
  double share = 0.0;           // of the way that is thought lost now
  double speed = 0.0;           // cm/s of the feet, a mean over about a step
  bool paused = false;          // no lines until the pose is confirmed
  double secondsPaused = 0.0;   // since something last held us
  std::uint32_t confirmed = 0;  // landmarks that the best mode predicted since
};

// How much the body has been shaken recently.
struct ShakeState {
  double mean = 0.0;       // cm/s2 to the left
  double deviation = 0.0;  // cm/s2 from it, a mean of absolute values
};

// A landmark that the best mode did not predict, where it would be seen now.
struct SurprisingSighting {
  bool present = false;
  double age = 0.0;  // s
  Point2<Field> landmark;
  Point2<Robot> place;
  double distanceVariance = 0.0;  // cm2
  double headingVariance = 0.0;   // rad2
};

// How the last sightings of one landmark went: the weight of the modes that they corrected, and of
// the copies for the case that they were false. Both fade.
struct SightingRecord {
  double believed = 0.0;
  double falseShare = 0.0;
};
using SightingRecords = std::array<SightingRecord, kLandmarkKindCount>;

// A landmark's sightings of the last moment, where it would be seen now.
struct LagReference {
  int sightings = 0;
  double age = 0.0;       // s, since the first
  Point2<Robot> place;    // their mean, now
  double variance = 0.0;  // rad2, of its bearing
  double rate = 0.0;      // rad/s, mean of their pan rates
  double turned = 0.0;    // rad, mean of these times the lags that they were read with
};
using LagReferences = std::array<LagReference, kLandmarkKindCount>;

// What steps differ by from what the odometry tells (OdometryErrors.h): scale ahead, scale aside,
// turn in rad/s. Covariances row by row.
struct OdometryErrors {
  std::array<double, 3> mean{};
  std::array<double, 9> covariance{};
  std::array<double, 9> cross{};  // of the best mode's pose (rows) with them
  PoseMode predicted;             // that mode, after it has moved
};

// Of one landmark from its place on the map, cm and cm2 in the team's field (LandmarkOffsets.h).
struct LandmarkOffset {
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
};
struct LandmarkOffsets {
  TeamColour team = TeamColour::red;
  std::array<LandmarkOffset, kLandmarkKindCount> landmarks{};
};

struct PoseState {
  bool started = false;
  bool lost = true;  // no landmark has been used since the start or the last loss of all modes
  Modes modes;
  double noiseScale = 1.0;  // of the variances
  FocalScale focal;
  ImageLag lag;
  LagReferences lagReferences{};
  OdometryErrors odometry;
  LandmarkOffsets offsets;
  SurprisingSighting surprising;
  SightingRecords sightings{};
  std::uint8_t kindsSeen = 0;  // a bit for each kind of landmark that was used since one gave modes
  std::uint32_t unexplained = 0;  // landmarks in a row that no mode predicted
  double secondsSinceLandmark = 0.0;
  double secondsSinceLines = 0.0;
  StuckState stuck;
  ShakeState shake;
  bool penalised = false;  // in the last frame
  bool lifted = false;     // so
};

}  // namespace kelpie::gps
