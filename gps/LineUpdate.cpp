// SPDX-License-Identifier: Apache-2.0
#include "gps/LineUpdate.h"

#include <algorithm>
#include <cmath>

#include "gps/Symmetry.h"
#include "gps/SymmetryUpdate.h"

namespace kelpie::gps {
namespace {

// Weight factor of a mode that is too wide for a fit when lines fit another. A wide one explains
// every landmark, so with 0.5 it outgrew the true one, whose weight a correction multiplies by 0.35
// on average.
constexpr double kWideWeight = 0.1;

// Too wide a mode does not tell which of the lines is seen.
bool isNarrow(const PoseMode& mode, const LineUpdateParams& params) {
  return mode.covariance[0] + mode.covariance[4] <= 2.0 * maths::square(params.maxSd) &&
         mode.covariance[8] <= maths::square(params.maxHeadingSd.rad());
}

bool isUnsure(const PoseMode& mode, const LineUpdateParams& params) {
  return mode.covariance[0] + mode.covariance[4] > 2.0 * maths::square(params.coarseAbove);
}

// However many points agree, the pose is known no better than the floor.
Matrix3 floored(const Matrix3& information, const LineUpdateParams& params) {
  const double place = maths::square(params.floorSd);
  const Vector3 variances(place, place, maths::square(params.floorHeadingSd.rad()));
  const Matrix3 sum = Matrix3::Identity() + variances.asDiagonal() * information;
  const Matrix3 result = information * sum.inverse();
  return 0.5 * (result + result.transpose());
}

}  // namespace

void correct(PoseMode& mode, const PoseObservation& observation) {
  const Matrix3 p = covarianceOf(mode);
  const Matrix3 sum = Matrix3::Identity() + p * observation.information;
  const Matrix3 a = sum.inverse();
  Vector3 innovation(observation.pose.position.x - mode.pose.position.x,
                     observation.pose.position.y - mode.pose.position.y,
                     (observation.pose.heading - mode.pose.heading).rad());
  const Matrix3 spread = observation.information * a;
  mode.weight *= maths::exp(-0.5 * std::max(0.0, innovation.dot(spread * innovation)));
  mode.pose = poseOf(meanOf(mode) + a * p * observation.information * innovation);
  setCovariance(mode, a * p);
}

std::optional<PoseObservation> observationOf(const LineFit& fit, const FieldFeatures& field,
                                             double headSpeed, const LineUpdateParams& params) {
  const double moving = params.headSpeed * headSpeed;
  const double away = field.outside(fit.pose.position).value;
  const double inside = maths::exp(-params.offField * away * away);
  if (fit.match * inside < params.match + params.matchStill / (1.0 + moving)) return std::nullopt;
  PoseObservation observation;
  observation.pose = fit.pose;
  observation.information = floored(fit.information / (1.0 + moving * moving), params);
  return observation;
}

std::optional<PoseObservation> observationAt(const PoseMode& mode, const SeenLines& seen,
                                             double headSpeed, const GpsParams& params,
                                             GpsState& state) {
  const LineUpdateParams& p = params.line;
  if (!isNarrow(mode, p)) return std::nullopt;
  const LineFit fit = fitLines(seen, mode.pose, state.features, p, isUnsure(mode, p));
  auto observation = observationOf(fit, state.features, headSpeed, p);
  if (!observation) state.count(Refusal::linesMatchNothing);
  if (observation) observation->information *= seen.newEvidenceShare;
  return observation;
}

double weightWithoutLineFit(const PoseMode& mode, const SeenLines& seen,
                            const LineUpdateParams& params) {
  const double kept = isNarrow(mode, params) ? params.refusedWeight : kWideWeight;
  return 1.0 - seen.newEvidenceShare * (1.0 - kept);
}

bool updateByLines(const SeenLines& seen, double headSpeed, const GpsParams& params,
                   GpsState& state) {
  const LineUpdateParams& p = params.line;
  if (seen.lines.size() < p.minPoints) return false;
  Modes& modes = state.modes;
  const std::size_t before = modes.size();
  FixedVector<std::optional<PoseObservation>, kWorkModes> found;
  bool any = false;
  for (std::size_t i = 0; i < std::min<std::size_t>(before, p.maxModes); ++i) {
    const bool light = modes[i].weight < p.minWeight * modes[0].weight;
    found.push_back(light ? std::nullopt : observationAt(modes[i], seen, headSpeed, params, state));
    any = any || found.back().has_value();
  }
  // Lines that fit no mode are false for all: modes with a failed fit must not lose weight against
  // modes without a fit.
  if (!any) return false;
  FixedVector<PoseMode, kMaxAmbiguousPoses> symmetric;
  if (found[0]) symmetric = symmetricModes(seen, *found[0], headSpeed, params, state);
  for (std::size_t i = 0; i < before; ++i) {
    if (i >= found.size() || !found[i]) {
      modes[i].weight *= weightWithoutLineFit(modes[i], seen, p);
      continue;
    }
    PoseMode copy = modes[i];
    copy.weight *= p.outlierWeight;
    correct(modes[i], *found[i]);
    modes.push_back(copy);
  }
  for (const PoseMode& mode : symmetric) modes.push_back(mode);
  return true;
}

}  // namespace kelpie::gps
