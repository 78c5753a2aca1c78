// SPDX-License-Identifier: Apache-2.0
#include "gps/lines/JointUpdate.h"

#include <algorithm>
#include <cmath>

#include "gps/pose/Modes.h"
#include "gps/pose/Update.h"

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

bool movedFar(const Pose2& from, const Pose2& to) {
  return distance(from.position, to.position) > 10.0 || (to.heading - from.heading).abs().deg() > 5;
}

// A wide mode moves so far that a linearisation at its old pose is wrong at the new one: it is
// linearised there again, as it would be by one landmark after the other.
UpdatedMode updatedByLandmarks(const PoseMode& mode, const Measurements& landmarks,
                               bool weighByDeterminant) {
  constexpr int kRounds = 3;
  UpdatedMode one;
  Pose2 at = mode.pose;
  for (int round = 0; round < kRounds; ++round) {
    one.information = informationOf(mode, at, landmarks);
    one.byLandmarks = corrected(mode, one.information, weighByDeterminant);
    if (!movedFar(at, one.byLandmarks.pose)) break;
    at = one.byLandmarks.pose;
  }
  return one;
}

UpdatedModes updatedModes(const Modes& modes, const Measurements& landmarks,
                          bool weighByDeterminant) {
  UpdatedModes all;
  for (const PoseMode& mode : modes)
    all.push_back(updatedByLandmarks(mode, landmarks, weighByDeterminant));
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
    one->lines = observationAt(one->byLandmarks, seen, field, params, counts);
    any = any || one->lines.has_value();
  }
  return any;
}

// What stays beside a corrected mode: the likelier of the mode itself and, for the case that only
// the lines are false, the mode as the landmarks alone correct it.
PoseMode copyOf(const PoseMode& mode, const UpdatedMode& one, bool landmarks,
                const JointParams& params) {
  PoseMode untouched = mode;
  if (landmarks) untouched.weight *= params.modes.outlierWeight;
  PoseMode withoutLines = one.byLandmarks;
  withoutLines.weight *= params.lines.outlierWeight;
  if (!one.lines) return untouched;
  return landmarks && untouched.weight > withoutLines.weight ? untouched : withoutLines;
}

// As when landmarks come one by one: after many in a row that no mode predicted, the robot is lost.
void countUnexplained(const Modes& modes, const UpdatedModes& updated, std::size_t landmarks,
                      const ModeParams& params, PoseState& state) {
  double copies = 0.0;
  double explained = 0.0;
  for (const PoseMode& mode : modes) copies += mode.weight * params.outlierWeight;
  for (const UpdatedMode& one : updated) explained += one.byLandmarks.weight;
  const bool predicted = explained > params.explainedShare * (copies + explained);
  state.unexplained = predicted ? 0 : state.unexplained + static_cast<std::uint32_t>(landmarks);
  if (state.unexplained <= params.maxUnexplained) return;
  state.unexplained = 0;
  state.lost = true;
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
  return corrected(mode, all, params.modes.weighByDeterminant);
}

}  // namespace

void InformationSum::add(const PoseMode& mode, const Measurement& m, const Pose2& at) {
  if (tooCloseToLinearise(at, m.landmark)) {
    degenerate = true;
    return;
  }
  const Expectation e = expected(at, m.landmark);
  const Point2<Field> away = at.position - mode.pose.position;
  const Vector3 offset(away.x, away.y, (at.heading - mode.pose.heading).rad());
  const double innovation[2] = {m.distance - e.distance, (m.heading - e.heading).rad()};
  const double variance[2] = {m.distanceVariance, m.headingVariance};
  const bool use[2] = {m.useDistance, m.useHeading};
  for (std::size_t row = 0; row < 2; ++row) {
    if (!use[row]) continue;
    const double* j = e.jacobian.data() + 3 * row;
    const Vector3 h(j[0], j[1], j[2]);
    const double fromMode = innovation[row] + h.dot(offset);
    matrix += h * h.transpose() / variance[row];
    vector += h * (fromMode / variance[row]);
    chiSquared += fromMode * fromMode / variance[row];
  }
}

void InformationSum::add(const PoseMode& mode, const PoseObservation& observation) {
  const Point2<Field> apart = observation.pose.position - mode.pose.position;
  const Vector3 innovation(apart.x, apart.y, (observation.pose.heading - mode.pose.heading).rad());
  const Vector3 pull = observation.information * innovation;
  matrix += observation.information;
  vector += pull;
  chiSquared += innovation.dot(pull);
}

PoseMode corrected(const PoseMode& mode, const InformationSum& information,
                   bool weighByDeterminant) {
  PoseMode result = mode;
  if (information.degenerate) {
    result.weight *= kDegenerateWeight;
    return result;
  }
  const Matrix3 p = covarianceOf(mode);
  const Matrix3 sum = Matrix3::Identity() + p * information.matrix;
  const Matrix3 after = sum.inverse() * p;
  const Vector3 shift = after * information.vector;
  // nu' E^-1 nu = nu' R^-1 nu - y' P' y, by the matrix inversion lemma.
  const double squaredInnovation =
      std::max(0.0, information.chiSquared - information.vector.dot(shift));
  result.weight *= maths::exp(-0.5 * squaredInnovation);
  if (weighByDeterminant) result.weight /= std::sqrt(sum.determinant());
  result.pose = poseOf(meanOf(mode) + shift);
  setCovariance(result, after);
  return result;
}

bool updateJointly(const Sightings& seen, const PaintedField& field, const JointParams& params,
                   PoseState& state, GpsCounts& counts) {
  Modes& modes = state.modes;
  const bool landmarks = !seen.landmarks.empty();
  if (landmarks && params.modes.noiseMethod == NoiseMethod::splitAndWide)
    modes.push_back(wideMode(field.description, params.modes, params.modes.wideWeight));
  UpdatedModes updated = updatedModes(modes, seen.landmarks, params.modes.weighByDeterminant);
  if (landmarks) countUnexplained(modes, updated, seen.landmarks.size(), params.modes, state);
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
