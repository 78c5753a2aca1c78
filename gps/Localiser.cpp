// SPDX-License-Identifier: Apache-2.0
#include "gps/Localiser.h"

#include <algorithm>
#include <cmath>

#include "gps/BallFilter.h"
#include "gps/DropIn.h"
#include "gps/Extract.h"
#include "gps/JointUpdate.h"
#include "gps/Landmarks.h"
#include "gps/Lines.h"
#include "gps/Modes.h"
#include "gps/Pinks.h"
#include "gps/Players.h"
#include "gps/Predict.h"
#include "gps/Stuck.h"
#include "gps/Symmetry.h"

namespace kelpie::gps {
namespace {

// No robot stands farther out than the carpet.
void keepNearField(const body::FieldDescription& field, Modes& modes) {
  for (PoseMode& mode : modes) {
    Point2<Field>& p = mode.pose.position;
    p.x = maths::clamp(p.x, -field.sideFringe, field.width + field.sideFringe);
    p.y = maths::clamp(p.y, -field.endFringe, field.length + field.endFringe);
  }
}

void useLandmarks(const GpsIn& in, const GpsParams& params, GpsState& state) {
  const LandmarkMap map = body::landmarksFor(params.field, in.input.game.team);
  for (const LandmarkPercept& percept : in.percepts.landmarks) {
    const auto m = measurement(percept, map, params, state);
    if (!m) continue;
    if (state.lost) {
      seedAround(*m, params, state);
    } else {
      updateAll(*m, params, state);
    }
    mergeAndPrune(params, state);
    keepNearField(params.field, state.modes);
    if (state.lost) continue;  // no place on the field fits it
    ++state.counts.updates;
    state.secondsSinceLandmark = 0.0;
    if (state.unexplained == 0) confirm(params.stuck, state.stuck);
  }
}

void useLines(const GpsIn& in, const GpsParams& params, GpsState& state) {
  if (!stepLines(in.input, in.percepts, params, state)) return;
  mergeAndPrune(params, state);
  keepNearField(params.field, state.modes);
  state.secondsSinceLines = 0.0;
}

bool inOneUpdate(const GpsParams& params, const GpsState& state) {
  return params.line.combine == LineCombine::joint && !state.lost &&
         params.modes.noiseMethod != NoiseMethod::refuse;
}

void useTogether(const GpsIn& in, const GpsParams& params, GpsState& state) {
  const LandmarkMap map = body::landmarksFor(params.field, in.input.game.team);
  Measurements landmarks;
  for (const LandmarkPercept& percept : in.percepts.landmarks)
    if (const auto m = measurement(percept, map, params, state)) landmarks.push_back(*m);
  SeenLines seen;
  if (linesUsable(params, state)) seen = seenLines(in.percepts.linePoints, params.line);
  if (!updateJointly(landmarks, seen, headSpeedOf(in.input), params, state)) return;
  mergeAndPrune(params, state);
  keepNearField(params.field, state.modes);
  if (state.lost || landmarks.empty()) return;
  state.counts.updates += static_cast<std::uint32_t>(landmarks.size());
  state.secondsSinceLandmark = 0.0;
  if (state.unexplained == 0) confirm(params.stuck, state.stuck);
}

// Moves the modes by the odometry, less where the robot is stuck.
Step move(const GpsIn& in, const GpsParams& params, GpsState& state) {
  Odometry walked = in.input.odometry;
  const bool sound = plausible(walked);
  if (!sound) walked = Odometry{};
  if (!sound || elapsedOf(in.input) != in.input.elapsed) state.count(Refusal::odometryNotFinite);
  const double excess = excessEffort(in.input, params.stuck, state);
  stepStuck(excess, elapsedOf(in.input), params.stuck, state.stuck);
  const StepNoise noise = stepNoise(walked, elapsedOf(in.input), params.motion);
  const Step step{shortened(walked, excess, params.stuck),
                  grown(noise, excess, elapsedOf(in.input), params.stuck)};
  for (PoseMode& mode : state.modes) predict(mode, step.odometry, step.noise);
  keepNearField(params.field, state.modes);
  return step;
}

}  // namespace

void prepare(const GpsParams& params, GpsState& state) {
  if (!state.features.built()) {
    state.features.build(params.field);
    state.painted = paintedFeatures(params.field);
  }
  if (!state.players.obstacles.built)
    build(params.field, params.players.obstacles, state.players.obstacles);
  if (!state.started) start(params, state);
}

WorldModel step(const GpsIn& in, const GpsParams& params, GpsState& state) {
  prepare(params, state);
  state.secondsSinceLandmark += elapsedOf(in.input);
  state.secondsSinceLines += elapsedOf(in.input);
  const Step moved = move(in, params, state);
  const bool joint = inOneUpdate(params, state) && landmarksCount(in.input);
  if (joint) {
    useTogether(in, params, state);
  } else if (landmarksCount(in.input)) {
    useLandmarks(in, params, state);
  }
  usePinks(in, moved.odometry, params, state);
  if (!joint) useLines(in, params, state);
  stepBall(in.input, in.percepts.ball, moved, params, state);
  applyReferee(in.input, params, state);
  WorldModel world = extract(state);
  stepPlayers(in, params, state, world);
  return world;
}

}  // namespace kelpie::gps
