// SPDX-License-Identifier: Apache-2.0
// A match of two teams as experiments judge it: the true places at each image, the referee's calls,
// and what each robot believed, sent its team and did. Truth is never given to an agent; here it is
// only read back.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "robot/core/types/Percepts.h"
#include "robot/core/types/TeamNote.h"
#include "tools/experiments/match/Matches.h"
#include "tools/session/Teams.h"
#include "tools/sim/rules/MatchScene.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::experiments {

// One frame of one robot, in its own team's field frame.
struct TeamFrame {
  double seconds = 0.0;
  PlayState state = PlayState::initial;
  bool penalised = false;
  TeamNote note;  // for the team
  Pose2 pose;
  BallPercept seen;   // in this image
  bool ball = false;  // of its own sightings
  Point2<Field> ballAt;
  bool teamBall = false;  // of all who agree
  Point2<Field> teamBallAt;

  bool plays() const { return state == PlayState::playing && !penalised; }
};

struct TeamRobot {
  TeamColour team = TeamColour::red;
  std::uint8_t player = 1;
  std::vector<TeamFrame> frames;

  bool is(const sim::RobotTruth& truth) const {
    return truth.team == team && truth.player == player;
  }
};

struct TeamMatch {
  std::vector<sim::TruthFrame> truth;
  std::vector<sim::MatchEvent> events;
  std::vector<TeamRobot> robots;

  // The world at that time: the last one not later; the first before the first.
  const sim::TruthFrame& at(double seconds) const;
};

bool isOwnGoal(const sim::MatchEvent& event);

// What is played: the sessions of the matches by their numbers, and who judges each as it ends.
struct TeamMatches {
  int count = 0;
  std::function<cli::SessionOptions(int number)> session;
  std::function<void(int number, const cli::SessionResult& result, const TeamMatch& match)> judge;
};

// A match of those teams, as "4v4", from a kick-off, so many seconds of play long.
Expected<cli::SessionOptions> teamSession(const Request& request, const Trial& trial,
                                          const std::string& robots, double seconds);

// One after the other: a match of eight robots takes all cores.
Status playTeams(const Request& request, const TeamMatches& matches);

// What is kept of a match for its judge: the frames of all robots, and truth and events; or these
// alone, a tenth faster.
enum class Kept { robots, world };
// Matches of four against four, one a trial.
struct Fours {
  double seconds = 0.0;  // of play
  Kept kept = Kept::robots;
  std::function<sim::Staging(std::uint64_t seed)> staging = {};  // none: as teams start
};
using JudgeMatch = std::function<void(const cli::SessionResult& result, const TeamMatch& match)>;
Status playFours(const Request& request, const Fours& fours, const JudgeMatch& judge);

}  // namespace kelpie::experiments
