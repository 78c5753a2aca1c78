// SPDX-License-Identifier: Apache-2.0
// How long a robot holds the ball and how far it takes it, from true places alone: what the rules
// limit to 3 s and 50 cm (Rules::holdingTime, holdingDistance; checklist A-6.4.1.1). A ball is held
// while it lies between chin, chest and forelegs and stays there. Cannot tell a ball that a robot
// only stands over from one that it grips; to a referee both are held.
#pragma once

#include <optional>
#include <vector>

#include "robot/body/Rules.h"
#include "robot/core/types/Geometry.h"

namespace kelpie::sim {

// Where a held ball's centre is, from the neck base. A grip has it 5 to 10 cm ahead
// (docs/physical-body.md); the rest is for a ball that bounces in it.
constexpr double kHeldNearest = 3.0;    // cm
constexpr double kHeldFurthest = 11.0;  // cm
constexpr double kHeldLateral = 4.0;    // cm
bool inHold(const Pose2& robot, Point2<Field> ball);

struct Hold {
  double begin = 0.0;   // s
  double end = 0.0;     // s; the last time that it was held
  double moved = 0.0;   // cm, the farthest that the robot got from where it began
  double turned = 0.0;  // rad, the most that it was turned from how it began
  Pose2 start;          // of the robot

  double seconds() const { return end - begin; }
  bool tooLong(const body::Rules& rules) const { return seconds() > rules.holdingTime; }
  bool tooFar(const body::Rules& rules) const { return moved > rules.holdingDistance; }
};

// Of one robot.
class HoldWatch {
 public:
  // The true places at one time; times go up. At least ten a second.
  void see(double seconds, const Pose2& robot, Point2<Field> ball);
  // The hold that goes on now: a ball that has been in its place for kSettles.
  const std::optional<Hold>& now() const { return now_; }
  // The holds that have ended, in their order.
  const std::vector<Hold>& ended() const { return ended_; }
  // The one that goes on counts as ended.
  void finish();

  // A ball that passes at 60 cm/s is in the place for 0.13 s.
  static constexpr double kSettles = 0.2;  // s
  // Bounces out of a grip and back take less; a kicked ball does not come back.
  static constexpr double kLost = 0.1;  // s

 private:
  std::optional<Hold> begun_;  // in its place, not yet settled
  std::optional<Hold> now_;
  std::vector<Hold> ended_;
};

}  // namespace kelpie::sim
