// SPDX-License-Identifier: Apache-2.0
#include "gps/Localiser.h"

#include "gps/Extract.h"
#include "gps/Refusal.h"
#include "gps/ball/BallFilter.h"
#include "gps/ball/DropIn.h"
#include "gps/lines/JointUpdate.h"
#include "gps/lines/LineMap.h"
#include "gps/lines/LinePoseSearch.h"
#include "gps/lines/LineUpdate.h"
#include "gps/lines/Lines.h"
#include "gps/lines/Symmetry.h"
#include "gps/pinks/Pinks.h"
#include "gps/players/Players.h"
#include "gps/pose/Landmarks.h"
#include "gps/pose/Modes.h"
#include "gps/pose/Predict.h"
#include "gps/pose/Stuck.h"

namespace kelpie::gps {
namespace {

PaintedField paintedField(const GpsParams& params, const GpsState& state) {
  return {params.field, state.lines.features, state.lines.painted};
}

// No robot stands farther out than the carpet.
void keepNearField(const body::FieldDescription& field, Modes& modes) {
  const body::Carpet carpet = body::carpetOf(field);
  for (PoseMode& mode : modes) mode.pose.position = carpet.nearest(mode.pose.position);
}

// After every change of the modes.
void finishUpdate(const GpsParams& params, GpsState& state) {
  mergeAndPrune(params.field, params.modes, state.pose, state.counts);
  keepNearField(params.field, state.pose.modes);
}

void noteLandmarks(std::size_t used, const StuckParams& params, GpsState& state) {
  state.counts.updates += static_cast<std::uint32_t>(used);
  state.pose.secondsSinceLandmark = 0.0;
  if (state.pose.unexplained == 0) confirm(params, state.pose.stuck);
}

Measurements measurements(const GpsIn& in, const GpsParams& params, GpsCounts& counts) {
  const LandmarkMap map = body::landmarksFor(params.field, in.input.game.team);
  Measurements all;
  for (const LandmarkPercept& percept : in.percepts.landmarks)
    if (const auto m = measurement(percept, map, params.field, params.gates, counts))
      all.push_back(*m);
  return all;
}

void useLandmarks(const GpsIn& in, const GpsParams& params, GpsState& state) {
  for (const Measurement& m : measurements(in, params, state.counts)) {
    if (state.pose.lost) {
      seedAround(m, params.field, params.modes, state.pose, state.counts);
    } else {
      updateAll(m, params.field, params.modes, state.pose, state.counts);
    }
    finishUpdate(params, state);
    if (!state.pose.lost) noteLandmarks(1, params.stuck, state);  // else no place on the field fits
  }
}

// Not after a scrum until the pose is confirmed.
bool linesUsable(const LineUpdateParams& params, const PoseState& pose) {
  return params.use && !pose.lost && !pose.stuck.paused;
}

bool updateByFrameOrMap(const GpsIn& in, const GpsParams& params, GpsState& state) {
  LineMap& map = state.lines.map;
  const SeenLines seen = linesOfFrameOrMap(in, params.lines, map);
  const bool used = updateByLines(seen, paintedField(params, state), params.lines, state.pose.modes,
                                  state.counts);
  const bool refused = !used && seen.lines.size() >= params.lines.update.minPoints;
  map.refused = refused ? map.refused + 1 : 0;
  return used;
}

void useLines(const GpsIn& in, const GpsParams& params, GpsState& state) {
  if (!params.lines.update.use) return;
  stepMap(in.input, in.percepts.linePoints, params.lines, state.lines.map);
  // Among pinks their own search finds the pose.
  const bool found =
      landmarksCount(in.input) &&
      stepLinePoseSearch(in.input, params.field, params.lines, state.lines, state.pose);
  const bool used = found || (linesUsable(params.lines.update, state.pose) &&
                              updateByFrameOrMap(in, params, state));
  if (!used) return;
  finishUpdate(params, state);
  state.pose.secondsSinceLines = 0.0;
}

bool inOneUpdate(const GpsParams& params, const PoseState& pose) {
  return params.lines.update.combine == LineCombine::joint && !pose.lost &&
         params.modes.noiseMethod != NoiseMethod::refuse;
}

void useTogether(const GpsIn& in, const GpsParams& params, GpsState& state) {
  Sightings seen;
  seen.landmarks = measurements(in, params, state.counts);
  if (linesUsable(params.lines.update, state.pose))
    seen.lines = linesOfFrame(in, params.lines.update);
  const bool used = updateJointly(seen, paintedField(params, state),
                                  {params.modes, params.lines.update}, state.pose, state.counts);
  if (!used) return;
  finishUpdate(params, state);
  if (state.pose.lost || seen.landmarks.empty()) return;
  noteLandmarks(seen.landmarks.size(), params.stuck, state);
}

void usePose(const GpsIn& in, const Odometry& moved, const GpsParams& params, GpsState& state) {
  const bool joint = inOneUpdate(params, state.pose) && landmarksCount(in.input);
  if (joint) {
    useTogether(in, params, state);
  } else if (landmarksCount(in.input)) {
    useLandmarks(in, params, state);
  }
  const PaintedField field = paintedField(params, state);
  usePinks({in, moved}, {field, params.pinks, params.modes, params.gates, params.lines.update},
           state.pinks, state.pose, state.counts);
  if (!joint) useLines(in, params, state);
}

// Moves the modes by the odometry, less where the robot is stuck.
Step move(const GpsIn& in, const GpsParams& params, PoseState& pose, GpsCounts& counts) {
  const double elapsed = elapsedOf(in.input);
  Odometry walked = in.input.odometry;
  const bool sound = plausible(walked);
  if (!sound) walked = Odometry{};
  if (!sound || elapsed != in.input.elapsed) count(Refusal::odometryNotFinite, counts);
  const double excess = excessEffort(in.input, params.stuck, pose.stuck, counts);
  stepStuck(excess, elapsed, params.stuck, pose.stuck);
  const StepNoise noise = stepNoise(walked, elapsed, params.motion);
  const Step step{shortened(walked, excess, params.stuck),
                  grown(noise, excess, elapsed, params.stuck)};
  for (PoseMode& mode : pose.modes) predict(mode, step.odometry, step.noise);
  keepNearField(params.field, pose.modes);
  return step;
}

}  // namespace

void prepare(const GpsParams& params, GpsState& state) {
  if (!state.lines.features.built()) {
    state.lines.features.build(params.field);
    state.lines.painted = paintedFeatures(params.field);
  }
  if (!state.pose.started) start(params.initialPose, params.field, params.modes, state.pose);
}

WorldModel step(const GpsIn& in, const GpsParams& params, GpsState& state) {
  prepare(params, state);
  state.pose.secondsSinceLandmark += elapsedOf(in.input);
  state.pose.secondsSinceLines += elapsedOf(in.input);
  const Step moved = move(in, params, state.pose, state.counts);
  usePose(in, moved.odometry, params, state);
  stepBall({in.input, in.percepts.ball, moved}, params.ball, state.ball.track, state.counts);
  applyReferee(in.input.game, params.field, params.ball, state.pose, state.ball);
  WorldModel world = extract(state, params.ball);
  stepPlayers(in, {params.field, params.players, params.ball}, state.players, state.counts, world);
  world.counts = state.counts;
  return world;
}

}  // namespace kelpie::gps
