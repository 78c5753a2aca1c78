// SPDX-License-Identifier: Apache-2.0
// What tries of a skill have in common: a match of some seconds with robots and ball at places of
// the try, played once in each of several ways by the same seeds.
#pragma once

#include <string>
#include <vector>

#include "behaviour/BehaviourParams.h"
#include "robot/core/Random.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/match/Matches.h"

namespace kelpie::experiments {

// How the robot plays in a part of the tries: --set words of its agent.
struct Way {
  const char* name = "";
  std::vector<std::string> set;
};

// One match of an experiment: the way and the trial. Ways times trials are played.
struct Try {
  std::size_t way = 0;
  Trial trial;
};

struct Tries {
  std::vector<Way> ways;
  int each = 1;                                                 // trials of each way
  std::function<void(const Try&, cli::SessionOptions&)> setUp;  // a session with seed and way
  std::function<void(const Try&, const cli::SessionResult&, const Played&)> judge;
};

Status playTries(const Request& request, const Tries& tries);

// What a try draws is the same in every way.
inline Random drawsOf(const Try& one) { return Random(one.trial.seed ^ 0x7219e55ULL); }

sim::RobotPlace placed(TeamColour team, const Pose2& pose, std::uint8_t player = 1);
// Blue 1 as that player; the scenario attack has it in front of its goal.
void addKeeper(PlayerKind player, cli::SessionOptions& session);
// A blue one, who stands there.
void addStanding(const Pose2& pose, cli::SessionOptions& session, std::uint8_t player = 1);

Angle headingTo(Point2<Field> from, Point2<Field> to);
// Where a ball would cross the line of the blue goal, across the field; nothing when it rolls away.
std::optional<double> crossing(const Shot& shot, double length);

}  // namespace kelpie::experiments
