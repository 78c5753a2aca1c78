// SPDX-License-Identifier: Apache-2.0
#include "gps/players/Players.h"

#include "gps/players/Opponents.h"
#include "gps/players/Team.h"
#include "gps/players/TeamBall.h"
#include "gps/pose/Predict.h"

namespace kelpie::gps {
namespace {

using Heard = FixedVector<TeamMessage, kTeammates>;

void stepObstacles(const GpsIn& in, const PlayersContext& context, const Heard& heard,
                   ObstacleMap& map, WorldModel& world) {
  const ObstacleMapParams& p = context.players.obstacles;
  forget(elapsedOf(in.input), p, map);
  see({in.percepts, world}, context.field, p, map);
  for (const TeamMessage& message : heard) hear(message, context.field, p, map);
  list(map, context.field, world.obstacles);
}

}  // namespace

void stepPlayers(const GpsIn& in, const PlayersContext& context, PlayersState& players,
                 GpsCounts& counts, WorldModel& world) {
  stepOpponents(in, world.modes[0], context, players.opponents, counts);
  const Heard heard = hear(in.input, context, players.mates, counts);
  for (const TeamMessage& message : heard) hearOpponents(message, context, players.opponents);
  stepObstacles(in, context, heard, players.obstacles, world);
  world.opponents = extractOpponents(players.opponents);
  world.teammates = extractMates(context.players.team, players.mates);
  const Witnesses witnesses = witnessesOf(world.ball, players.mates, context);
  world.teamBall = fused(witnesses, context.players.teamBall);
  speak(in.input, world, context, players);
  world.message = players.message;
}

}  // namespace kelpie::gps
