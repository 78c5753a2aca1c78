// SPDX-License-Identifier: Apache-2.0
// What the localiser remembers between frames: the modes of the pose, the ball and the counts.
// Plain data: a copy is a snapshot, and GpsState{} is the state before the first frame.
#pragma once

#include <array>
#include <cstdint>

#include "gps/FieldFeatures.h"
#include "gps/LineState.h"
#include "gps/PinkState.h"
#include "gps/PlayersState.h"
#include "robot/core/WorldModel.h"

namespace kelpie::gps {

// Why something was not used; the index into GpsCounts::refused.
enum class Refusal : std::uint8_t {
  odometryNotFinite,  // or farther than a robot can walk in one frame, or without a sound time
  landmarkNotFinite,  // or without a positive variance
  landmarkUnknown,    // the field has no such landmark
  headingUncertain,
  goalTooClose,
  goalTooOblique,   // seen from next to its own goal line
  nothingMeasured,  // neither distance nor heading passed its gate
  seedOffField,     // no place on the field explains the first landmark
  modeNotFinite,    // a hypothesis was removed
  ballNotFinite,
  ballOutsideGate,  // waits for a second sighting like it
  messageBroken,    // something in a mate's message cannot be
  messageRepeated,  // or it is older than the last
  opponentNotFinite,
  opponentUncertain,  // vague, or far from the field
  linesMatchNothing,  // near a likely mode
  effortNotFinite,    // or not what a mean of duties can be
  pinkNotFinite,
  pinkPoseUnsure,  // the robot knows its own place too badly to map what it sees
  pinkOffWall,     // its direction meets no wall
  pinkElevation,   // too low or too high for the wall
  pinkNearBeacon,
  pinkMapFull,
};
constexpr std::size_t kRefusalCount = 23;

// Each of the modes and the wide one may be split in two.
constexpr std::size_t kWorkModes = 2 * (kMaxModes + 1);
using Modes = FixedVector<PoseMode, kWorkModes>;

// Position and velocity in the robot frame: x right, y forward, vx, vy; covariance row by row.
struct BallHypothesis {
  double weight = 0.0;
  std::array<double, 4> mean{};
  std::array<double, 16> covariance{};
};

struct BallTrack {
  bool present = false;
  BallHypothesis still;    // it lies: no velocity and no variance of it
  BallHypothesis rolling;  // it rolls freely, slowed by the carpet
  BallHypothesis both;     // one Gaussian for the two: what is published
  double secondsSinceSeen = 0.0;
  double weightedUnseenSeconds = 0.0;  // seconds in which it should be seen count more
  std::uint32_t missed = 0;            // frames in a row in which it should have been seen
  bool candidatePresent = false;       // a sighting that waits for a second one like it
  std::array<double, 2> candidate{};
  double candidateAge = 0.0;  // s
};

// How hard walking has been recently.
struct StuckState {
  double share = 0.0;           // of the way that is thought lost now
  double speed = 0.0;           // cm/s of the feet, a mean over about a step
  bool paused = false;          // no lines until the pose is confirmed
  double secondsPaused = 0.0;   // since something last held us
  std::uint32_t confirmed = 0;  // landmarks that the best mode predicted since
};

struct GpsState {
  bool started = false;
  bool lost = true;  // no landmark has been used since the start or the last loss of all modes
  Modes modes;
  double secondsSinceLandmark = 0.0;
  double secondsSinceLines = 0.0;
  StuckState stuck;
  std::uint32_t unexplained = 0;  // landmarks in a row that no mode predicted
  BallTrack ball;
  PlayersState players;
  PinkState pinks;
  GpsCounts counts;
  LineMap map;
  LinePoseSearch search;
  FieldFeatures features;   // built by prepare()
  PaintedFeatures painted;  // with them

  void count(Refusal reason) { ++counts.refused[static_cast<std::size_t>(reason)]; }
};

}  // namespace kelpie::gps
