// SPDX-License-Identifier: Apache-2.0
// Starting places by scenario name.
#include "robot/core/Random.h"
#include "tools/sim/World.h"

namespace kelpie::sim {
namespace {

constexpr double kBallFromLines = 40.0;   // cm
constexpr double kRobotFromLines = 50.0;  // cm
constexpr double kApart = 40.0;           // cm between robot and ball at the start

Setup anywhere(const body::FieldDescription& field, Random& random) {
  Setup setup;
  setup.ball = {random.uniform(kBallFromLines, field.width - kBallFromLines),
                random.uniform(kBallFromLines, field.length - kBallFromLines)};
  Pose2 start;
  do {
    start = {{random.uniform(kRobotFromLines, field.width - kRobotFromLines),
              random.uniform(kRobotFromLines, field.length - kRobotFromLines)},
             Angle::rad(random.uniform(-maths::kPi, maths::kPi))};
  } while (distance(start.position, setup.ball) < kApart);
  setup.players.push_back({TeamColour::red, 1, start});
  return setup;
}

// Own half, one row for each player number; blue's half is red's turned by 180 degrees.
Pose2 kickoffPlace(const body::FieldDescription& field, const host::AgentHello& agent) {
  const double x = field.width * (agent.player % 2 == 0 ? 0.3 : 0.65);
  const double y = field.length * (0.5 - 0.11 * agent.player);
  if (agent.team == TeamColour::red) return {{x, y}, Angle::deg(90.0)};
  return {{field.width - x, field.length - y}, Angle::deg(-90.0)};
}

}  // namespace

Expected<Setup> scenario(const std::string& name, const body::FieldDescription& field,
                         const std::vector<host::AgentHello>& agents, std::uint64_t seed) {
  Random random(seed ^ 0x5ce7a210ULL);
  if (name == "empty-goal") {
    if (agents.size() != 1) return Error{"scenario empty-goal is for one robot"};
    Setup setup = anywhere(field, random);
    setup.players[0].team = agents[0].team;
    setup.players[0].number = agents[0].player;
    return setup;
  }
  if (name == "kickoff") {
    Setup setup;
    setup.ball = {field.width / 2.0, field.length / 2.0};
    for (const host::AgentHello& agent : agents) {
      setup.players.push_back({agent.team, agent.player, kickoffPlace(field, agent)});
    }
    return setup;
  }
  return Error{"no scenario \"" + name + "\"; there are empty-goal and kickoff"};
}

}  // namespace kelpie::sim
