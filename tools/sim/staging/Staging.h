// SPDX-License-Identifier: Apache-2.0
// What a person sets up beside a scenario: robots at places of their own, the ball, and later
// interventions: balls that are thrown, the ball taken away, robots carried off. As words of a
// command line:
//
//   place   TEAM:PLAYER:X,Y,DEG             red:1:180,100,90
//   ball    X,Y or X,Y,VX,VY                180,270,0,50
//   throw   T:X,Y,VX,VY or ...:TEAM:PLAYER  4.5:-20,10,-80,0:red:1
//   take    T, T:SECONDS, T:SECONDS:X,Y     30:5:100,200
//   carry   T:TEAM:PLAYER:X,Y,DEG           30:red:2:100,200,90
//
// in cm, cm/s, deg and s; the field is the red team's, and with a robot's name at its end a throw
// is in that robot's frame: to its right, ahead.
#pragma once

#include "tools/sim/world/Setup.h"

namespace kelpie::sim {

struct RobotPlace {
  host::AgentHello robot;
  Pose2 pose;
};

struct Staging {
  std::vector<RobotPlace> places;
  std::optional<Ball> ball;
  std::vector<BallThrow> throws;
  std::vector<BallTake> takes = {};
  std::vector<RobotCarry> carries = {};
  std::vector<host::AgentHello> deaf = {};  // whose radio sends and does not receive
};

// An error is one line with the words in it.
Expected<RobotPlace> placeFrom(const std::string& words);
Expected<Ball> ballFrom(const std::string& words);
Expected<BallThrow> throwFrom(const std::string& words);
Expected<BallTake> takeFrom(const std::string& words);
Expected<RobotCarry> carryFrom(const std::string& words);
std::optional<host::AgentHello> robotFrom(const std::string& words);  // TEAM:PLAYER

// Whether the ball may be put there, and that robot carried there; an error says why not.
Status checkBall(const body::FieldDescription& field, const Ball& ball);
Status checkCarry(const body::FieldDescription& field, const std::vector<host::AgentHello>& agents,
                  const RobotCarry& carry);

struct StagingWords {
  std::vector<std::string> places;
  std::string ball;  // empty: the scenario's
  std::vector<std::string> throws;
  std::vector<std::string> takes = {};
  std::vector<std::string> carries = {};
  std::vector<std::string> deaf = {};  // TEAM:PLAYER
};
Expected<Staging> stagingFrom(const StagingWords& words);

// The words that mean the same again.
std::string wordsFor(const RobotPlace& place);
std::string wordsFor(const Ball& ball);
std::string wordsFor(const BallThrow& thrown);
std::string wordsFor(const BallTake& take);
std::string wordsFor(const RobotCarry& carry);
std::string wordsFor(const host::AgentHello& robot);

// The scenario of the robots that have no place of their own, then what is staged. Refuses what is
// off the field, names of robots that are not there, robots in each other, in a goal or beacon, or
// on the ball, and a ball that is taken or thrown while it is away.
Expected<Setup> stagedScenario(const std::string& name, const body::FieldDescription& field,
                               const std::vector<host::AgentHello>& agents, std::uint64_t seed,
                               const Staging& staging);

}  // namespace kelpie::sim
