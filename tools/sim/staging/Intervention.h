// SPDX-License-Identifier: Apache-2.0
// What a person does to a match that is under way: takes the ball away and brings it back, carries
// a robot elsewhere. Each deed is a MatchEvent. A robot is carried as soon as its new place is free
// of robots and ball. While the ball is away it lies where no camera sees it, and the referee calls
// nothing but the time.
#pragma once

#include <vector>

#include "tools/sim/rules/RuledMatch.h"
#include "tools/sim/world/Setup.h"

namespace kelpie::sim {

class Intervention {
 public:
  Intervention(const Setup& setup, const body::FieldDescription& field);

  // Somebody puts the ball there now; one that was away is back with that.
  void putBall(TimeUs now, Point2<Field> place);
  // Somebody carries a robot from that time on. Of one robot the last order counts.
  void carry(const RobotCarry& order);

  // What is due at the scene's time.
  Verdict step(const MatchScene& scene);
  bool ballAway() const { return away_; }
  Point2<Field> takenFrom() const { return takenFrom_; }
  std::vector<MatchEvent> takeEvents();

 private:
  struct Carrying {
    RobotCarry order;
    bool done = false;
  };
  void moveBall(const MatchScene& scene, Verdict& verdict);
  void carryRobots(const MatchScene& scene, Verdict& verdict);
  void record(const MatchScene& scene, EventKind kind);

  std::vector<BallTake> takes_;
  std::vector<Carrying> carries_;
  std::size_t taken_ = 0;  // of takes_
  Point2<Field> middle_;
  bool away_ = false;
  Point2<Field> takenFrom_;
  std::vector<MatchEvent> events_;
};

}  // namespace kelpie::sim
