// SPDX-License-Identifier: Apache-2.0
#include "gps/PoseSteps.h"

#include <algorithm>

#include "gps/Refusal.h"
#include "gps/camera/EdgeElevation.h"
#include "gps/camera/Focal.h"
#include "gps/camera/Lag.h"
#include "gps/camera/Tilt.h"
#include "gps/lines/LineMap.h"
#include "gps/lines/LinePoseSearch.h"
#include "gps/lines/LineUpdate.h"
#include "gps/lines/Lines.h"
#include "gps/pinks/Pinks.h"
#include "gps/pose/Crossing.h"
#include "gps/pose/LandmarkOffsets.h"
#include "gps/pose/Modes.h"
#include "gps/pose/NoiseScale.h"
#include "gps/pose/OdometryErrors.h"
#include "gps/pose/Outliers.h"
#include "gps/pose/PoseUpdate.h"
#include "gps/pose/Shake.h"
#include "gps/pose/Stuck.h"

namespace kelpie::gps {
namespace {

// No robot stands farther out than the carpet.
void keepNearField(const body::FieldDescription& field, Modes& modes) {
  const body::Carpet carpet = body::carpetOf(field);
  for (PoseMode& mode : modes) mode.pose.position = carpet.nearest(mode.pose.position);
}

// What a landmark tells beside the pose.
void noteSighting(const GpsIn& in, const Measurement& seen, const GpsParams& params,
                  PoseState& state) {
  const PoseMode& best = state.modes[0];
  updateFocal(in, best, seen, params.focal, state.focal);
  const LagView view{in.input, state.noiseScale * lateVariance(in.input),
                     state.odometry.covariance[8]};
  updateLag(view, seen, params.lag, state.lagReferences, state.lag);
  const Innovation bearing = bearingInnovation(best, seen);
  noteInnovation(best, maths::square(bearing.value) / bearing.variance, params.noiseScale,
                 state.noiseScale);
}

void scaleBy(double scale, Measurement& m) {
  m.distanceVariance *= scale;
  m.headingVariance *= scale;
  m.grazingHeadingVariance *= scale;
}

bool updateByFrameOrMap(const GpsIn& in, const GpsParams& params, GpsState& state) {
  LineMap& map = state.lines.map;
  SeenLines seen = linesOfFrameOrMap(in, params.lines, map);
  seen.noiseScale = state.pose.noiseScale;
  seen.shaking = shaking(state.pose.shake);
  const PoseMode before = state.pose.modes[0];
  const auto squared = updateByLines(seen, state.lines.features, params.lines.update,
                                     state.pose.modes, state.counts);
  const bool used = squared.has_value();
  if (used) noteInnovation(before, *squared, params.noiseScale, state.pose.noiseScale);
  if (!params.tilt.joint)
    for (PoseMode& mode : state.pose.modes) mode.cross = {};
  const bool refused = !used && seen.lines.size() >= params.lines.update.minPoints;
  map.refused = refused ? map.refused + 1 : 0;
  return used;
}

// Among pinks their own search finds the pose.
bool foundByLines(const GpsIn& in, const GpsParams& params, GpsState& state) {
  return params.lines.update.use == LineUse::position && landmarksCount(in.input) &&
         stepLinePoseSearch(in.input, params.field, params.lines, state.lines, state.pose);
}

}  // namespace

Step moveModes(const GpsIn& in, const GpsParams& params, GpsState& state) {
  PoseState& pose = state.pose;
  const double elapsed = elapsedOf(in.input);
  pose.secondsSinceLandmark += elapsed;
  pose.secondsSinceLines += elapsed;
  fade(elapsed, params.modes, pose.sightings);
  Odometry walked = in.input.odometry;
  const bool sound = plausible(walked);
  if (!sound) walked = Odometry{};
  if (!sound || elapsed != in.input.elapsed) count(Refusal::odometryNotFinite, state.counts);
  const double excess = excessEffort(in.input, params.stuck, pose.stuck, state.counts);
  stepStuck(excess, elapsed, params.stuck, pose.stuck);
  const double shake = excessShake(in.input, params.shake, pose.shake);
  const auto inContact = [&](const StepNoise& noise) {
    return shaken(grown(noise, excess, elapsed, params.stuck), shake, elapsed, params.shake);
  };
  const StepNoise noise = stepNoise(walked, elapsed, params.motion);
  const Odometry held = shortened(shortened(walked, excess, params.stuck), shake, params.shake);
  const Step step{corrected(held, elapsed, pose.odometry), inContact(noise)};
  const StepNoise scaled = inContact(scaledBy(pose.noiseScale, noise));
  predictAll(held, {step.odometry, scaled}, elapsed, params.odometryErrors, pose);
  driftOffsets(in.input.game.team, elapsed, params.landmarkOffsets, pose.offsets);
  driftTilt(elapsed, shaking(pose.shake), params.tilt, pose.modes);
  moveCrossing(step.odometry, elapsed, pose.surprising);
  moveLagReferences(step.odometry, elapsed, pose.lagReferences);
  keepNearField(params.field, pose.modes);
  return step;
}

void useElevations(const GpsIn& in, const GpsParams& params, GpsState& state) {
  if (!params.tilt.use) return;
  Modes& modes = state.pose.modes;
  const CameraTilt& readWith = in.camera.tilt;
  useTiltSightings(elevationSightings(in, params.tilt), readWith, params.tilt, modes, state.counts);
  if (state.pose.lost) return;
  useTiltSightings(edgeSightings(in, params.field, params.tilt, modes[0]), readWith, params.tilt,
                   modes, state.counts);
}

Measurements measurements(const GpsIn& in, const GpsParams& params, GpsCounts& counts) {
  Measurements all;
  if (!landmarksCount(in.input)) return all;
  const LandmarkMap map = body::landmarksFor(params.field, in.input.game.team);
  const double late = lateVariance(in.input);
  for (const LandmarkPercept& percept : in.percepts.landmarks)
    if (auto m = measurement(percept, map, params.field, params.gates, counts)) {
      m->headingVariance += late;
      m->grazingHeadingVariance += late;
      all.push_back(*m);
    }
  return all;
}

void finishUpdate(const GpsParams& params, GpsState& state) {
  mergeAndPrune(params.field, params.modes, state.pose, state.counts);
  keepNearField(params.field, state.pose.modes);
}

void noteLandmarks(std::size_t used, const StuckParams& params, GpsState& state) {
  state.counts.updates += static_cast<std::uint32_t>(used);
  state.pose.secondsSinceLandmark = 0.0;
  if (state.pose.unexplained == 0) confirm(params, state.pose.stuck);
}

void useLandmarks(const GpsIn& in, const GpsParams& params, GpsState& state,
                  LandmarkUpdate update) {
  for (Measurement m : measurements(in, params, state.counts)) {
    scaleBy(state.pose.noiseScale, m);
    const Measurement seen = displaced(m, params.landmarkOffsets, state.pose.offsets);
    if (state.pose.lost) {
      seedAround(seen, params.field, params.modes, state.pose, state.counts);
      state.pose.kindsSeen = 0;
    } else {
      m = doubted(seen, state.pose.offsets);
      noteSighting(in, m, params, state.pose);
      learnOffset(state.pose.modes[0], seen, params.landmarkOffsets, state.pose.offsets,
                  state.counts);
      cross(m, params.field, params.crossing, params.modes, state.pose);
      update(m, params.field, params.modes, state.pose, state.counts);
    }
    finishUpdate(params, state);
    state.pose.kindsSeen |= static_cast<std::uint8_t>(1U << static_cast<unsigned>(seen.kind));
    if (!state.pose.lost) noteLandmarks(1, params.stuck, state);  // else no place on the field fits
  }
}

bool linesUsable(const LineUpdateParams& params, const PoseState& pose) {
  return params.use != LineUse::off && !pose.lost && !pose.stuck.paused;
}

void useLines(const GpsIn& in, const GpsParams& params, GpsState& state) {
  if (params.lines.update.use == LineUse::off) return;
  stepMap(in.input, in.percepts.linePoints, params.lines, state.lines.map);
  const bool used =
      foundByLines(in, params, state) ||
      (linesUsable(params.lines.update, state.pose) && updateByFrameOrMap(in, params, state));
  if (!used) return;
  finishUpdate(params, state);
  state.pose.secondsSinceLines = 0.0;
}

void usePinkPatches(const GpsIn& in, const Odometry& moved, const GpsParams& params,
                    GpsState& state) {
  const PaintedField field{params.field, state.lines.features};
  usePinks({in, moved}, {field, params.pinks, params.modes, params.gates, params.lines.update},
           state.pinks, state.pose, state.counts);
}

}  // namespace kelpie::gps
