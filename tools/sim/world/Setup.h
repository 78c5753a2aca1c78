// SPDX-License-Identifier: Apache-2.0
// Who starts where in a match, and which balls somebody throws later. Places are those of the red
// team's field, as in Truth.h.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "robot/core/Expected.h"
#include "robot/host/world/WorldProtocol.h"
#include "tools/sim/world/Ball.h"

namespace kelpie::sim {

struct Player {
  TeamColour team = TeamColour::red;
  std::uint8_t number = 1;
  Pose2 start;
  bool deaf = false;  // its radio sends and does not receive

  bool is(const host::AgentHello& agent) const {
    return team == agent.team && number == agent.player;
  }
};

// A hand puts the ball somewhere and lets it roll from there. Place and velocity are the field's,
// or those of the robot frame that `by` stands in at that time.
struct BallThrow {
  double time = 0.0;  // s
  Ball ball;
  std::optional<host::AgentHello> by;
};

// A hand takes the ball away and puts it back later.
struct BallTake {
  double time = 0.0;                  // s
  double seconds = 5.0;               // until it is back
  std::optional<Point2<Field>> back;  // where; else in the middle
};

// Somebody carries a robot elsewhere.
struct RobotCarry {
  double time = 0.0;  // s
  host::AgentHello robot;
  Pose2 pose;
};

struct Setup {
  std::vector<Player> players;
  Point2<Field> ball;
  Point2<Field> ballVelocity;     // cm/s
  std::vector<BallThrow> throws;  // in the order of time
  std::vector<BallTake> takes;    // so; none begins before the one ahead has ended
  std::vector<RobotCarry> carries;
};

// "empty-goal": one robot and the ball anywhere. "attack": one robot in the three fifths of the
// field farther from the goal that it attacks, one of the other team, if there is one, in the
// middle of that goal, the ball anywhere but in a goal box; of two, red attacks. "kickoff": ball in
// the middle, robots in their own halves. Players come in the order of the agents.
Expected<Setup> scenario(const std::string& name, const body::FieldDescription& field,
                         const std::vector<host::AgentHello>& agents, std::uint64_t seed);

// How messages call a robot: "red 1".
std::string nameOf(const host::AgentHello& agent);

}  // namespace kelpie::sim
