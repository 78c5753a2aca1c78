// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/baselines/PoseVariants.h"

#include <cmath>

#include "gps/PoseSteps.h"
#include "gps/lines/Lines.h"
#include "gps/pose/Outliers.h"
#include "gps/pose/PoseUpdate.h"
#include "tools/experiments/baselines/JointUpdate.h"
#include "tools/experiments/baselines/SymmetryUpdate.h"

namespace kelpie::gps {
namespace {

constexpr double kRefuseBelow = 0.01;                 // weight factor of a refused landmark
constexpr double kRadPerCm = 0.5 * maths::kPi / 180;  // a heading grows by 5 deg with 10 cm

// A goal at a grazing angle gives no distance.
Measurement usedOf(const Measurement& m, const PoseMode& mode) {
  return atGrazingAngle(mode, m) ? headingOnly(m) : m;
}

template <int kGrowthCm>
void refuseUnlikely(const Measurement& m, const body::FieldDescription&, const ModeParams&,
                    PoseState& state, GpsCounts&) {
  for (PoseMode& mode : state.modes) {
    const PoseMode after = corrected(mode, usedOf(m, mode));
    if (after.weight >= kRefuseBelow * mode.weight) {
      mode = after;
      continue;
    }
    mode.covariance[0] += maths::square(kGrowthCm);
    mode.covariance[4] += maths::square(kGrowthCm);
    mode.covariance[8] += maths::square(kGrowthCm * kRadPerCm);
  }
}

// As updateAll(), weighed by the determinant.
void updateByDeterminant(const Measurement& m, const body::FieldDescription& field,
                         const ModeParams& params, PoseState& state, GpsCounts&) {
  Modes& modes = state.modes;
  modes.push_back(wideMode(field, params, params.wideWeight));
  const std::size_t before = modes.size();
  SplitWeights weights;
  for (std::size_t i = 0; i < before; ++i) {
    const PoseMode mode = modes[i];
    modes.push_back(outlierCopy(mode, params.outlierWeight));
    modes[i] = corrected(mode, usedOf(m, mode));
    modes[i].weight *=
        std::sqrt(covarianceOf(modes[i]).determinant() / covarianceOf(mode).determinant());
    weights.copies += modes.back().weight;
    weights.corrected += modes[i].weight;
  }
  countUnexplainedLandmarks(weights, params, 1, state);
}

void useTogether(const GpsIn& in, const GpsParams& params, GpsState& state) {
  const PaintedField field{params.field, state.lines.features};
  Sightings seen;
  seen.landmarks = measurements(in, params, state.counts);
  if (linesUsable(params.lines.update, state.pose))
    seen.lines = linesOfFrame(in, params.lines.update);
  if (!updateJointly(seen, field, {params.modes, params.lines.update}, state.pose, state.counts))
    return;
  finishUpdate(params, state);
  if (!state.pose.lost && !seen.landmarks.empty())
    noteLandmarks(seen.landmarks.size(), params.stuck, state);
}

void useLinesAndSymmetry(const GpsIn& in, const GpsParams& params, GpsState& state) {
  if (!linesUsable(params.lines.update, state.pose)) return;
  const PaintedField field{params.field, state.lines.features};
  const SeenLines seen = linesOfFrame(in, params.lines.update);
  if (!updateByLinesAndSymmetry(seen, field, params.lines.update, state.pose.modes, state.counts))
    return;
  finishUpdate(params, state);
  state.pose.secondsSinceLines = 0.0;
}

}  // namespace

WorldModel stepRefusing(const GpsIn& in, const GpsParams& params, GpsState& state) {
  return stepWith(refuseUnlikely<10>, in, params, state);
}

WorldModel stepRefusingSlowly(const GpsIn& in, const GpsParams& params, GpsState& state) {
  return stepWith(refuseUnlikely<2>, in, params, state);
}

WorldModel stepByDeterminant(const GpsIn& in, const GpsParams& params, GpsState& state) {
  return stepWith(updateByDeterminant, in, params, state);
}

// The first landmarks give modes one after the other, as ever.
WorldModel stepJointly(const GpsIn& in, const GpsParams& params, GpsState& state) {
  prepare(params, state);
  const Step moved = moveModes(in, params, state);
  const bool together = !state.pose.lost;
  if (together) {
    useTogether(in, params, state);
  } else {
    useLandmarks(in, params, state);
    useLines(in, params, state);
  }
  return believe(in, moved, params, state);
}

WorldModel stepWithSymmetry(const GpsIn& in, const GpsParams& params, GpsState& state) {
  prepare(params, state);
  const Step moved = moveModes(in, params, state);
  useLandmarks(in, params, state);
  useLinesAndSymmetry(in, params, state);
  return believe(in, moved, params, state);
}

}  // namespace kelpie::gps
