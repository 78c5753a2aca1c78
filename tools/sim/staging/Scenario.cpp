// SPDX-License-Identifier: Apache-2.0
// Starting places by scenario name.
#include <cmath>

#include "robot/core/Random.h"
#include "tools/sim/world/Setup.h"

namespace kelpie::sim {
namespace {

constexpr double kBallFromLines = 40.0;   // cm
constexpr double kRobotFromLines = 50.0;  // cm
constexpr double kApart = 40.0;           // cm between robot and ball at the start
constexpr double kAttackersShare = 0.6;   // of the field's length, from the attacker's own end
// cm from its goal line to its neck base (checklist A-4.3.1.7).
constexpr double kKeeperFromLine = 20.0;

// A robot up to that y and a ball, apart.
void drawBoth(const body::FieldDescription& field, double highest, Random& random, Pose2& start,
              Point2<Field>& ball) {
  ball = {random.uniform(kBallFromLines, field.width - kBallFromLines),
          random.uniform(kBallFromLines, field.length - kBallFromLines)};
  do {
    start = {{random.uniform(kRobotFromLines, field.width - kRobotFromLines),
              random.uniform(kRobotFromLines, highest)},
             Angle::rad(random.uniform(-maths::kPi, maths::kPi))};
  } while (distance(start.position, ball) < kApart);
}

// From red's field to blue's and back.
Point2<Field> turned(const body::FieldDescription& field, Point2<Field> p) {
  return {field.width - p.x, field.length - p.y};
}
Pose2 turned(const body::FieldDescription& field, const Pose2& pose) {
  return {turned(field, pose.position), pose.heading + Angle::deg(180.0)};
}

Expected<Setup> emptyGoal(const body::FieldDescription& field,
                          const std::vector<host::AgentHello>& agents, Random& random) {
  if (agents.size() > 1) return Error{"scenario empty-goal is for one robot"};
  Setup setup;
  Pose2 start;
  drawBoth(field, field.length - kRobotFromLines, random, start, setup.ball);
  for (const host::AgentHello& agent : agents)
    setup.players.push_back({agent.team, agent.player, start});
  return setup;
}

bool inGoalBox(const body::FieldDescription& field, Point2<Field> p) {
  const double fromEnd = std::fmin(p.y, field.length - p.y);
  return fromEnd < field.boxDepth && std::fabs(p.x - field.width / 2.0) < field.boxWidth / 2.0;
}

Expected<Setup> attack(const body::FieldDescription& field,
                       const std::vector<host::AgentHello>& agents, Random& random) {
  if (agents.size() > 2 || (agents.size() == 2 && agents[0].team == agents[1].team))
    return Error{"scenario attack is for one robot, or one of each team"};
  Setup setup;
  Pose2 start;
  do {
    drawBoth(field, kAttackersShare * field.length, random, start, setup.ball);
  } while (inGoalBox(field, setup.ball));
  const Pose2 keeper{{field.width / 2.0, field.length - kKeeperFromLine}, Angle::deg(-90.0)};
  const bool blueAttacks = agents.size() == 1 && agents[0].team == TeamColour::blue;
  if (blueAttacks) setup.ball = turned(field, setup.ball);
  for (const host::AgentHello& agent : agents) {
    const bool attacks = agent.team == TeamColour::red || blueAttacks;
    const Pose2 pose = attacks ? start : keeper;
    setup.players.push_back({agent.team, agent.player, blueAttacks ? turned(field, pose) : pose});
  }
  return setup;
}

// Own half, one row for each player number; blue's half is red's turned by 180 degrees.
Pose2 kickoffPlace(const body::FieldDescription& field, const host::AgentHello& agent) {
  const double x = field.width * (agent.player % 2 == 0 ? 0.3 : 0.65);
  const double y = field.length * (0.5 - 0.11 * agent.player);
  const Pose2 ofRed{{x, y}, Angle::deg(90.0)};
  return agent.team == TeamColour::red ? ofRed : turned(field, ofRed);
}

Setup kickoff(const body::FieldDescription& field, const std::vector<host::AgentHello>& agents) {
  Setup setup;
  setup.ball = {field.width / 2.0, field.length / 2.0};
  for (const host::AgentHello& agent : agents)
    setup.players.push_back({agent.team, agent.player, kickoffPlace(field, agent)});
  return setup;
}

}  // namespace

Expected<Setup> scenario(const std::string& name, const body::FieldDescription& field,
                         const std::vector<host::AgentHello>& agents, std::uint64_t seed) {
  Random random(seed ^ 0x5ce7a210ULL);
  if (name == "empty-goal") return emptyGoal(field, agents, random);
  if (name == "attack") return attack(field, agents, random);
  if (name == "kickoff") return kickoff(field, agents);
  return Error{"no scenario \"" + name + "\"; there are attack, empty-goal and kickoff"};
}

std::string nameOf(const host::AgentHello& agent) {
  return std::string(agent.team == TeamColour::red ? "red " : "blue ") +
         std::to_string(agent.player);
}

}  // namespace kelpie::sim
