// SPDX-License-Identifier: Apache-2.0
#include "gps/Localiser.h"

#include <algorithm>
#include <cmath>

#include "gps/BallFilter.h"
#include "gps/DropIn.h"
#include "gps/Extract.h"
#include "gps/Landmarks.h"
#include "gps/LineUpdate.h"
#include "gps/Modes.h"
#include "gps/Others.h"
#include "gps/Pinks.h"
#include "gps/Predict.h"
#include "robot/body/Camera.h"

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
  if (!params.line.use || state.lost) return;
  const SeenLines seen = seenLines(in.percepts.linePoints, params.line);
  constexpr double kUnknown = 1.0;  // rad a frame: faster than any head
  const double speed = body::headSpeed(in.input.headRate);
  if (!updateByLines(seen, std::isfinite(speed) ? speed : kUnknown, params, state)) return;
  tidy(params, state);
  keepNearField(params.field, state.modes);
}

}  // namespace

WorldModel step(const GpsIn& in, const GpsParams& params, GpsState& state) {
  if (!state.features.built()) state.features.build(params.field);
  if (!state.started) start(params, state);
  state.secondsSinceLandmark += in.input.elapsed;
  Odometry odometry = in.input.odometry;
  if (!plausible(odometry)) {
    odometry = Odometry{};
    state.count(Refusal::odometryNotFinite);
  }
  const StepNoise noise = stepNoise(odometry, in.input.elapsed, params.motion);
  for (PoseMode& mode : state.modes) predict(mode, odometry, noise);
  keepNearField(params.field, state.modes);
  if (landmarksCount(in.input)) useLandmarks(in, params, state);
  usePinks(in, odometry, params, state);
  useLines(in, params, state);
  stepBall(in.input, in.percepts.ball, noise, params, state);
  applyReferee(in.input, params, state);
  WorldModel world = extract(state);
  stepOthers(in, params, state, world);
  return world;
}

}  // namespace kelpie::gps
