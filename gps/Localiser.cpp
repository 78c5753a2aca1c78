// SPDX-License-Identifier: Apache-2.0
#include "gps/Localiser.h"

#include "gps/Ahead.h"
#include "gps/Extract.h"
#include "gps/PoseSteps.h"
#include "gps/ball/BallFilter.h"
#include "gps/ball/DropIn.h"
#include "gps/camera/Focal.h"
#include "gps/camera/Lag.h"
#include "gps/camera/Tilt.h"
#include "gps/players/BallLandmark.h"
#include "gps/players/Players.h"
#include "gps/pose/LandmarkOffsets.h"
#include "gps/pose/OdometryErrors.h"
#include "gps/pose/Return.h"

namespace kelpie::gps {

void prepare(const GpsParams& params, GpsState& state) {
  if (!state.lines.features.built()) state.lines.features.build(params.field);
  if (state.pose.started) return;
  start(params.initialPose, params.field, params.modes, state.pose);
  state.pose.modes[0].tilt = startingTilt(params.tilt);
  state.pose.focal = startingFocal(params.focal);
  state.pose.lag = startingLag(params.lag);
  state.pose.odometry = startingErrors(params.odometryErrors);
  state.pose.offsets = startingOffsets(params.landmarkOffsets);
}

namespace {

void believeInto(WorldModel& world, const GpsIn& in, const Step& moved, const GpsParams& params,
                 GpsState& state) {
  stepBall({in.input, in.percepts.ball, moved}, params.ball, state.ball, state.counts);
  applyReferee(in.input.game, params.field, params.ball, state.pose, state.ball);
  const PlayersContext players{params.field, params.players, params.ball};
  if (!state.pose.lost && correctByBall(state.ball.track, players, state.players, state.pose.modes))
    finishUpdate(params, state);
  learnErrors(params.odometryErrors, state.pose);
  extractInto(world, state, params);
  stepPlayers(in, players, state.players, state.counts, world);
  world.counts = state.counts;
  bringForward(sinceExposure(in.input), world);
}

// The pose's part of a step.
Step stepPose(LandmarkUpdate update, const GpsIn& in, const GpsParams& params, GpsState& state) {
  prepare(params, state);
  const Step moved = moveModes(in, params, state);
  stepLift(in.input.motion.feeling.lifted, params.field, params.modes, state.pose);
  stepReturn(in.input.game, params.field, params.afterPenalty, state.pose);
  useElevations(in, params, state);
  useLandmarks(in, params, state, update);
  usePinkPatches(in, moved.odometry, params, state);
  useLines(in, params, state);
  return moved;
}

}  // namespace

WorldModel believe(const GpsIn& in, const Step& moved, const GpsParams& params, GpsState& state) {
  WorldModel world;
  believeInto(world, in, moved, params, state);
  return world;
}

WorldModel stepWith(LandmarkUpdate update, const GpsIn& in, const GpsParams& params,
                    GpsState& state) {
  return believe(in, stepPose(update, in, params, state), params, state);
}

void stepInto(WorldModel& world, const GpsIn& in, const GpsParams& params, GpsState& state) {
  believeInto(world, in, stepPose(updateAll, in, params, state), params, state);
}

WorldModel step(const GpsIn& in, const GpsParams& params, GpsState& state) {
  return stepWith(updateAll, in, params, state);
}

}  // namespace kelpie::gps
