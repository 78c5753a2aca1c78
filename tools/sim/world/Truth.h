// SPDX-License-Identifier: Apache-2.0
// What really happened, for logs and experiments. Nothing here ever reaches an agent. Poses and
// points are those of the red team's field: red defends the yellow goal at y = 0.
#pragma once

#include "robot/core/FixedVector.h"
#include "robot/core/Text.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Geometry.h"
#include "robot/core/types/Motion.h"

namespace kelpie::sim {

constexpr const char* kTruthTopic = "/truth";
constexpr const char* kEventTopic = "/event";
constexpr const char* kMatchNotes = "match";  // metadata: which match it is
constexpr std::size_t kMaxRobots = 8;

struct RobotTruth {
  TeamColour team = TeamColour::red;
  std::uint8_t player = 1;
  Pose2 pose;     // of the robot frame: the ground below the neck base
  Stance stance;  // of the real joints

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("team", &RobotTruth::team, "", 0, 1),
                     field("player", &RobotTruth::player, "", 1, 4),
                     field("pose", &RobotTruth::pose), field("stance", &RobotTruth::stance));
  }
};

// Where the ball is while somebody has taken it away: far outside every room, seen by nobody.
constexpr Point2<Field> kAwayBall{-10000.0, -10000.0};

// At the end of an image's exposure.
struct TruthFrame {
  TimeUs time;
  FixedVector<RobotTruth, kMaxRobots> robots;
  Point2<Field> ball;
  Point2<Field> ballVelocity;  // cm/s
  std::uint8_t redScore = 0;
  std::uint8_t blueScore = 0;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("time", &TruthFrame::time, "us"), field("robots", &TruthFrame::robots),
        field("ball", &TruthFrame::ball), field("ballVelocity", &TruthFrame::ballVelocity, "cm/s"),
        field("redScore", &TruthFrame::redScore), field("blueScore", &TruthFrame::blueScore));
  }
};

// In recorded logs by number: append, never reorder. Those from `ready` to `placed` come of the
// rules only (RefereeParams::rules).
enum class EventKind : std::uint8_t {
  start,
  goal,
  out,
  end,
  ready,    // for the team's kick-off
  set,      // all stand where they may
  play,     // the whistle
  half,     // the first half is over
  penalty,  // a robot is taken off
  back,     // it comes back
  stuck,    // the ball went nowhere and is put elsewhere
  placed,   // a robot is put by hand where it may stand for the kick-off
  // Of the user's interventions (Intervention.h):
  taken,     // the ball is taken away
  returned,  // it lies at `place` again
  carried,   // the robot is put down at `place`
};

struct MatchEvent {
  TimeUs time;
  EventKind kind = EventKind::start;
  TeamColour team = TeamColour::red;  // that scored, that kicks off, or the robot's
  Point2<Field> ball;                 // where it was
  std::uint8_t player = 0;            // the robot's; of a goal, its who touched last; 0 = none
  Text<40> reason;                    // in words
  Point2<Field> place;                // where the robot was, or where the ball is put

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("time", &MatchEvent::time, "us"),
                     field("kind", &MatchEvent::kind, "", 0, 14),
                     field("team", &MatchEvent::team, "", 0, 1), field("ball", &MatchEvent::ball),
                     field("player", &MatchEvent::player, "", 0, 4),
                     field("reason", &MatchEvent::reason), field("place", &MatchEvent::place));
  }
};

}  // namespace kelpie::sim
