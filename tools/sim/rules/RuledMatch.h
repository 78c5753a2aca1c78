// SPDX-License-Identifier: Apache-2.0
// A match by the rules of the field description: the steps of this folder in their order over one
// scene, and what is then put elsewhere. While the ball is in play: last toucher, goals,
// balls out, fouls, a stuck ball; always: penalties that end and the clock. Every call is one
// MatchEvent. Assumes scenes of the same players, in the order of time.
#pragma once

#include <optional>
#include <vector>

#include "robot/net/GameControlData.h"
#include "tools/sim/rules/Holding.h"
#include "tools/sim/rules/KickOff.h"
#include "tools/sim/rules/MatchClock.h"
#include "tools/sim/rules/Penalties.h"
#include "tools/sim/rules/Pushing.h"
#include "tools/sim/rules/Score.h"
#include "tools/sim/rules/Stuck.h"
#include "tools/sim/rules/Touch.h"

namespace kelpie::sim {

// What is to be moved: the ball put somewhere, robots carried somewhere.
struct Carry {
  std::size_t robot = 0;
  Pose2 place;
};
struct Verdict {
  std::optional<Ball> ball;
  FixedVector<Carry, kMaxRobots> carries;  // at most one for each robot
};

class RuledMatch {
 public:
  // From a kick-off the ball is put in the middle; in play it stays where it is.
  RuledMatch(const body::FieldDescription& field, const ClockState& clock);

  // `playing` and `lastToucher` of the scene are not read.
  Verdict step(const MatchScene& scene, Score& score);
  bool finished() const { return clock_.state == PlayState::finished; }
  const ClockState& clock() const { return clock_; }
  bool penalised(std::size_t player) const { return penalties_.of[player].off; }
  std::vector<MatchEvent> takeEvents();

  // The match as that player's behaviours know it.
  GameState gameFor(std::size_t player, const Score& score) const;
  // The match as the game controller would broadcast it.
  net::GameControlData control(const Score& score) const;

 private:
  struct Call {
    EventKind kind;
    const char* reason = "";
  };
  void record(Call call, TeamColour team);
  void record(Call call, std::size_t player);
  void judgePlay(Score& score);
  void judgeGoal(TeamColour team, Score& score);
  void judgeFouls(const Fouls& fouls, Score& score);
  void judgePenalties();
  void runClock();
  void takePlaces();
  void goOn();
  void putBall(Point2<Field> place);
  void carry(std::size_t player, const Pose2& place);

  body::FieldDescription field_;
  ClockState clock_;
  KickOffState kickOff_;
  TouchState touch_;
  FoulState fouls_;
  HoldingState holding_;
  PushingState pushing_;
  StuckState stuck_;
  PenaltyState penalties_;
  std::optional<TeamColour> goal_;  // in this step
  TeamColour dropInTeam_ = TeamColour::red;
  std::optional<TimeUs> droppedIn_;
  bool started_ = false;
  MatchScene scene_;
  Verdict verdict_;
  std::vector<MatchEvent> events_;
};

}  // namespace kelpie::sim
