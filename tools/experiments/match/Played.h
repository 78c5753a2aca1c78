// SPDX-License-Identifier: Apache-2.0
// A match as experiments judge it: in the time of each image the true places of all robots and the
// ball, beside what the first robot's agent saw, decided and did in that frame. Truth is never
// given to an agent; here it is only read back.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/types/Command.h"
#include "robot/core/types/Motion.h"
#include "robot/core/types/Percepts.h"
#include "tools/sim/bodies/HoldWatch.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::experiments {

struct PlayedMoment {
  sim::TruthFrame truth;  // at the end of the image's exposure
  bool seen = false;      // the agent got that image; else the rest is empty
  BallPercept ball;
  MotionStatus motion;  // when the image came
  Command command;

  double seconds() const { return truth.time.seconds(); }
  // The first robot of that team; the match has one.
  Pose2 robot(TeamColour team) const;
};

struct Played {
  std::vector<PlayedMoment> moments;
  std::vector<sim::MatchEvent> events;

  // When the ball first left the field, or went into a goal, after `from`; nothing when it did not.
  std::optional<double> outAfter(double from) const;
};

Expected<Played> readPlayed(const std::string& agentLog, const std::string& worldLog);

// Whether what a robot at that true pose took for the ball in one image is the ball.
bool isBall(const BallPercept& seen, const Pose2& robot, Point2<Field> ball);

// How often and how long the first robot of that team held the ball.
std::vector<sim::Hold> holdsOf(const Played& played, TeamColour team);

// A ball that a robot set rolling.
struct Shot {
  double time = 0.0;  // s
  Point2<Field> from;
  Angle direction;     // over the field, as a heading
  double speed = 0.0;  // cm/s
  std::size_t moment = 0;
};
// Of a robot of that team: a ball near it that comes to more than 60 cm/s, which walking into it
// does not give.
std::vector<Shot> shotsOf(const Played& played, TeamColour team);

// Of that red robot; null when there is none.
const Pose2* redPose(const sim::TruthFrame& truth, std::uint8_t player);

// Of the robots, of which there is one at least.
const sim::RobotTruth& nearestToBall(const sim::TruthFrame& truth);

}  // namespace kelpie::experiments
