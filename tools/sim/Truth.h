// SPDX-License-Identifier: Apache-2.0
// What really happened, for logs and experiments. Nothing here ever reaches an agent. Poses and
// points are those of the red team's field: red defends the yellow goal at y = 0.
#pragma once

#include "robot/core/FixedVector.h"
#include "robot/core/FrameInput.h"
#include "robot/core/Geometry.h"
#include "robot/core/Motion.h"

namespace kelpie::sim {

constexpr const char* kTruthTopic = "/truth";
constexpr const char* kEventTopic = "/event";
constexpr std::size_t kMaxRobots = 8;

struct RobotTruth {
  TeamColour team = TeamColour::red;
  std::uint8_t player = 1;
  Pose2 pose;     // of the robot frame: the ground below the neck base
  Stance stance;  // of the real joints

  static constexpr auto fields() {
    return fieldList(field("team", &RobotTruth::team, "", 0, 1),
                     field("player", &RobotTruth::player, "", 1, 4),
                     field("pose", &RobotTruth::pose), field("stance", &RobotTruth::stance));
  }
};

// At the end of an image's exposure.
struct TruthFrame {
  TimeUs time;
  FixedVector<RobotTruth, kMaxRobots> robots;
  Point2<Field> ball;
  Point2<Field> ballVelocity;  // cm/s
  std::uint8_t redScore = 0;
  std::uint8_t blueScore = 0;

  static constexpr auto fields() {
    return fieldList(
        field("time", &TruthFrame::time, "us"), field("robots", &TruthFrame::robots),
        field("ball", &TruthFrame::ball), field("ballVelocity", &TruthFrame::ballVelocity, "cm/s"),
        field("redScore", &TruthFrame::redScore), field("blueScore", &TruthFrame::blueScore));
  }
};

enum class EventKind : std::uint8_t { start, goal, out, end };

struct MatchEvent {
  TimeUs time;
  EventKind kind = EventKind::start;
  TeamColour team = TeamColour::red;  // that scored
  Point2<Field> ball;                 // where it was

  static constexpr auto fields() {
    return fieldList(field("time", &MatchEvent::time, "us"),
                     field("kind", &MatchEvent::kind, "", 0, 3),
                     field("team", &MatchEvent::team, "", 0, 1), field("ball", &MatchEvent::ball));
  }
};

}  // namespace kelpie::sim
