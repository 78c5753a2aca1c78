// SPDX-License-Identifier: Apache-2.0
#include "gps/Localiser.h"

#include <algorithm>
#include <cmath>

#include "gps/BallFilter.h"
#include "gps/DropIn.h"
#include "gps/Extract.h"
#include "gps/Landmarks.h"
#include "gps/Lines.h"
#include "gps/Modes.h"
#include "gps/Others.h"
#include "gps/Predict.h"
#include "gps/Symmetry.h"

namespace kelpie::gps {
namespace {

// Nobody stands farther out than the carpet.
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
    tidy(params, state);
    keepNearField(params.field, state.modes);
    if (state.lost) continue;  // no place on the field fits it
    ++state.counts.updates;
    state.secondsSinceLandmark = 0.0;
  }
}

void useLines(const GpsIn& in, const GpsParams& params, GpsState& state) {
  if (!stepLines(in.input, in.percepts, params, state)) return;
  tidy(params, state);
  keepNearField(params.field, state.modes);
}

void prepare(const GpsParams& params, GpsState& state) {
  if (!state.features.built()) {
    state.features.build(params.field);
    state.painted = paintedFeatures(params.field);
  }
  if (!state.started) start(params, state);
}

}  // namespace

WorldModel step(const GpsIn& in, const GpsParams& params, GpsState& state) {
  prepare(params, state);
  state.secondsSinceLandmark += in.input.elapsed;
  Odometry odometry = in.input.odometry;
  if (!plausible(odometry)) {
    odometry = Odometry{};
    state.count(Refusal::odometryNotFinite);
  }
  const StepNoise noise = stepNoise(odometry, in.input.elapsed, params.motion);
  for (PoseMode& mode : state.modes) predict(mode, odometry, noise);
  keepNearField(params.field, state.modes);
  useLandmarks(in, params, state);
  useLines(in, params, state);
  stepBall(in.input, in.percepts.ball, noise, params, state);
  applyReferee(in.input, params, state);
  WorldModel world = extract(state);
  stepOthers(in, params, state, world);
  return world;
}

}  // namespace kelpie::gps
