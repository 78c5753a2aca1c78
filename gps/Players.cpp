// SPDX-License-Identifier: Apache-2.0
#include "gps/Players.h"

#include "gps/BallMotion.h"
#include "gps/ObstacleQueries.h"
#include "gps/OnField.h"
#include "gps/Opponents.h"
#include "gps/Predict.h"
#include "gps/Team.h"
#include "gps/TeamBall.h"

namespace kelpie::gps {
namespace {

// Where the ball will lie: each model's end, weighed.
Point2<Robot> stoppingPointOf(const BallTrack& ball, const BallFilterParams& params) {
  const std::array<double, 4>& rolling = ball.rolling.mean;
  const double speed = maths::hypot(rolling[2], rolling[3]);
  const double way = speed > 0.0 ? rollingDistance(speed, params) / speed : 0.0;
  const double share = ball.rolling.weight;
  return {ball.both.mean[0] + share * way * rolling[2],
          ball.both.mean[1] + share * way * rolling[3]};
}

void putBallOnField(const GpsParams& params, const GpsState& state, BallEstimate& ball) {
  if (!ball.present) return;
  const PoseMode& pose = state.modes[0];
  const Place place = placeOnField(pose, ball.relative, matrixOf(ball.covariance));
  ball.fieldCovariance = rowsOf(place.covariance);
  ball.stoppingPoint = fieldFromRobot(pose.pose, stoppingPointOf(state.ball, params.ball));
}

using Heard = FixedVector<TeamMessage, kTeammates>;

ObstacleEstimate stepObstacles(const GpsIn& in, const GpsParams& params, const Heard& heard,
                               const WorldModel& world, ObstacleMap& map) {
  const ObstacleMapParams& p = params.players.obstacles;
  forget(elapsedOf(in.input), p, map);
  see({in.percepts, world}, params.field, p, map);
  for (const TeamMessage& message : heard) hear(message, params.field, p, map);
  return extractObstacles({map, params.field, p}, world);
}

}  // namespace

void stepPlayers(const GpsIn& in, const GpsParams& params, GpsState& state, WorldModel& world) {
  putBallOnField(params, state, world.ball);
  stepOpponents(in, params, state);
  const Heard heard = hear(in.input, params, state);
  for (const TeamMessage& message : heard) hearOpponents(message, params, state);
  world.obstacles = stepObstacles(in, params, heard, world, state.players.obstacles);
  const PlayersState& players = state.players;
  world.opponents = extractOpponents(players);
  world.teammates = extractMates(params.players.team, players);
  world.teamBall = fused(witnessesOf(params, world.ball, players), params.players.teamBall);
  speak(in.input, world, params.players.team, state.players);
  world.message = players.message;
  world.counts = state.counts;
}

}  // namespace kelpie::gps
