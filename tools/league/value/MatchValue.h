// SPDX-License-Identifier: Apache-2.0
// What a match was worth to its teams, beside its goals: the far value of every moment of play,
// added up in expected goals; by the near value kicks, what each gained, and which were shots at
// the goal; and whose doing each change of the value was. That is the robot which had the ball in
// reach last, the nearest one of several: two at the ball may be taken for one another.
#pragma once

#include <array>
#include <vector>

#include "tools/league/value/PlayedTruth.h"
#include "tools/league/value/Value.h"

namespace kelpie::value {

// A ball that a robot set rolling, not by walking into it.
struct Kick {
  double seconds = 0.0;
  TeamColour team = TeamColour::red;
  std::uint8_t player = 1;
  double gained = 0.0;  // own value less the other team's: after it less before it
  bool shot = false;    // it would cross the goal line in the mouth or beside it
  double goals = 0.0;   // of a shot: the own value after it
};

// What the value changed in 0.1 s of play, by the doing of a robot that had the ball in reach then
// or last. The last one before a goal ends at 1 for the team that scored.
struct Doing {
  double seconds = 0.0;  // when the ball was in its reach
  TeamColour team = TeamColour::red;
  std::uint8_t player = 1;
  double lasts = 0.0;   // s
  double gained = 0.0;  // as of a kick
};

// In goals; for one team.
struct TeamMinute {
  double value = 0.0;
  int goals = 0;
};

struct TeamFigures {
  int goals = 0;
  double value = 0.0;  // of all moments: expected goals
  int shots = 0;
  double shotGoals = 0.0;           // expected ones of the shots
  std::vector<TeamMinute> minutes;  // of play, in their order; the last may be shorter
};

struct MatchFigures {
  double played = 0.0;                 // s
  std::array<TeamFigures, 2> teams{};  // by TeamColour
  std::vector<Kick> kicks;
  std::vector<Doing> doings;

  const TeamFigures& of(TeamColour team) const { return teams[static_cast<std::size_t>(team)]; }
  // As red sees it, in expected goals.
  double value() const { return of(TeamColour::red).value - of(TeamColour::blue).value; }
};

// Of the match that a log holds; an error as readTruth().
Expected<MatchFigures> figuresOfLog(const std::string& path, const Models& models,
                                    const body::FieldDescription& field);

// Of a scene of so many seconds, which ends at a goal, as red sees it: for what is left of its time
// the team that scored counts as one that is sure to. Else a team lost by scoring soon. `horizon`:
// of the far model.
double sceneValue(const MatchFigures& figures, double horizon, double seconds);

MatchFigures figuresOf(const PlayedTruth& match, const Models& models,
                       const body::FieldDescription& field);

}  // namespace kelpie::value
