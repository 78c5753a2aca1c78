// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/baselines/JointUpdate.h"

#include <algorithm>
#include <cmath>

#include "gps/SamePose.h"
#include "gps/pose/Modes.h"
#include "gps/pose/Outliers.h"

namespace kelpie::gps {
namespace {

// What one mode becomes: by the landmarks alone, and by all.
struct UpdatedMode {
  InformationSum information;
  PoseMode byLandmarks;
  bool lineFitTried = false;
  std::optional<PoseObservation> lines;
};
using UpdatedModes = FixedVector<UpdatedMode, kWorkModes>;

InformationSum informationOf(const PoseMode& mode, const Pose2& at, const Measurements& landmarks) {
  InformationSum information;
  for (const Measurement& m : landmarks)
    information.add(mode, atGrazingAngle(mode, m) ? headingOnly(m) : m, at);
  return information;
}

// A wide mode moves so far that a linearisation at its old pose is wrong at the new one: it is
// linearised there again, as it would be by one landmark after the other.
UpdatedMode updatedByLandmarks(const PoseMode& mode, const Measurements& landmarks) {
  constexpr int kRounds = 3;
  constexpr double kNearCm = 10.0;
  constexpr double kNearDeg = 5.0;
  UpdatedMode one;
  Pose2 at = mode.pose;
  for (int round = 0; round < kRounds; ++round) {
    one.information = informationOf(mode, at, landmarks);
    one.byLandmarks = corrected(mode, one.information);
    if (samePose(at, one.byLandmarks.pose, kNearCm, kNearDeg)) break;
    at = one.byLandmarks.pose;
  }
  return one;
}

UpdatedModes updatedModes(const Modes& modes, const Measurements& landmarks) {
  UpdatedModes all;
  for (const PoseMode& mode : modes) all.push_back(updatedByLandmarks(mode, landmarks));
  return all;
}

// The heaviest of those not tried yet.
UpdatedMode* heaviest(UpdatedModes& all) {
  UpdatedMode* best = nullptr;
  for (UpdatedMode& one : all) {
    if (one.lineFitTried) continue;
    if (best == nullptr || one.byLandmarks.weight > best->byLandmarks.weight) best = &one;
  }
  return best;
}

// Fits the lines near the heaviest of them; true when any fits.
bool fitLinesToHeaviest(const SeenLines& seen, const FieldFeatures& field,
                        const LineUpdateParams& params, UpdatedModes& all, GpsCounts& counts) {
  if (seen.lines.size() < params.minPoints) return false;
  double first = 0.0;
  bool any = false;
  for (std::uint32_t tried = 0; tried < params.maxModes; ++tried) {
    UpdatedMode* one = heaviest(all);
    if (one == nullptr || one->byLandmarks.weight < params.minWeight * first) break;
    first = std::max(first, one->byLandmarks.weight);
    one->lineFitTried = true;
    if (const auto o = observationAt(one->byLandmarks, seen, field, params, counts))
      one->lines = o->pose;
    any = any || one->lines.has_value();
  }
  return any;
}

// What stays beside a corrected mode: the likelier of the mode itself and, for the case that only
// the lines are false, the mode as the landmarks alone correct it.
PoseMode copyOf(const PoseMode& mode, const UpdatedMode& one, bool landmarks,
                const JointParams& params) {
  const PoseMode untouched = landmarks ? outlierCopy(mode, params.modes.outlierWeight) : mode;
  const PoseMode withoutLines = outlierCopy(one.byLandmarks, params.lines.outlierWeight);
  if (!one.lines) return untouched;
  return landmarks && untouched.weight > withoutLines.weight ? untouched : withoutLines;
}

SplitWeights splitWeights(const Modes& modes, const UpdatedModes& updated, double outlierWeight) {
  SplitWeights weights;
  for (const PoseMode& mode : modes) weights.copies += mode.weight * outlierWeight;
  for (const UpdatedMode& one : updated) weights.corrected += one.byLandmarks.weight;
  return weights;
}

// `seen` is null where no mode's lines fit.
PoseMode result(const PoseMode& mode, const UpdatedMode& one, const SeenLines* seen,
                const JointParams& params) {
  if (!one.lines) {
    PoseMode kept = one.byLandmarks;
    if (seen != nullptr) kept.weight *= weightWithoutLineFit(kept, *seen, params.lines);
    return kept;
  }
  InformationSum all = one.information;
  all.add(mode, *one.lines);
  return corrected(mode, all);
}

}  // namespace

bool updateJointly(const Sightings& seen, const PaintedField& field, const JointParams& params,
                   PoseState& state, GpsCounts& counts) {
  Modes& modes = state.modes;
  const bool landmarks = !seen.landmarks.empty();
  if (landmarks && params.modes.wideWeight > 0.0)
    modes.push_back(wideMode(field.description, params.modes, params.modes.wideWeight));
  UpdatedModes updated = updatedModes(modes, seen.landmarks);
  if (landmarks)
    countUnexplainedLandmarks(splitWeights(modes, updated, params.modes.outlierWeight),
                              params.modes, seen.landmarks.size(), state);
  const bool lines = fitLinesToHeaviest(seen.lines, field.features, params.lines, updated, counts);
  if (!landmarks && !lines) return false;
  if (lines) state.secondsSinceLines = 0.0;
  const std::size_t before = modes.size();
  for (std::size_t i = 0; i < before; ++i) {
    if (!landmarks && !updated[i].lines) {
      modes[i].weight *= weightWithoutLineFit(modes[i], seen.lines, params.lines);
      continue;
    }
    const PoseMode copy = copyOf(modes[i], updated[i], landmarks, params);
    modes[i] = result(modes[i], updated[i], lines ? &seen.lines : nullptr, params);
    modes.push_back(copy);
  }
  return true;
}

}  // namespace kelpie::gps
