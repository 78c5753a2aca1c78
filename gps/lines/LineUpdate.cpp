// SPDX-License-Identifier: Apache-2.0
#include "gps/lines/LineUpdate.h"

#include <algorithm>
#include <cmath>

#include "gps/Refusal.h"
#include "gps/pose/Outliers.h"

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
  const double tilt = std::max(mode.tilt.tiltVariance, mode.tilt.rollVariance);
  return mode.covariance[0] + mode.covariance[4] > 2.0 * maths::square(params.coarseAbove) ||
         tilt > maths::square(params.coarseAboveTilt.rad());
}

// However many points agree, the pose is known no better than the floor.
template <int N>
Eigen::Matrix<double, N, N> floored(const Eigen::Matrix<double, N, N>& information,
                                    const LineUpdateParams& params) {
  using Square = Eigen::Matrix<double, N, N>;
  Square floor = Square::Zero();
  floor(0, 0) = floor(1, 1) = maths::square(params.floorSd);
  floor(2, 2) = maths::square(params.floorHeadingSd.rad());
  const Square sum = Square::Identity() + floor * information;
  const Square result = information * sum.inverse();
  return 0.5 * (result + result.transpose());
}

// Of an observation whose heading is as much less sure: (Y^-1 + v h h')^-1.
template <int N>
Eigen::Matrix<double, N, N> turnedBy(double variance, const Eigen::Matrix<double, N, N>& y) {
  const Eigen::Matrix<double, N, 1> heading = y.col(2);
  return y - heading * heading.transpose() * (variance / (1.0 + variance * y(2, 2)));
}

// Points that are seen late lie turned about the robot.
void blurByLag(double variance, LineObservation& seen) {
  if (!(variance > 0.0)) return;
  seen.pose.information = turnedBy<3>(variance, seen.pose.information);
  seen.information = turnedBy<5>(variance, seen.information);
}

using Observations = FixedVector<std::optional<LineObservation>, kWorkModes>;

// Of the heaviest modes; none for the lighter ones.
Observations observationsAt(const SeenLines& seen, const FieldFeatures& field,
                            const LineUpdateParams& params, const Modes& modes, GpsCounts& counts) {
  Observations found;
  for (std::size_t i = 0; i < std::min<std::size_t>(modes.size(), params.maxModes); ++i) {
    const bool light = modes[i].weight < params.minWeight * modes[0].weight;
    found.push_back(light ? std::nullopt : observationAt(modes[i], seen, field, params, counts));
  }
  return found;
}

// The mode's own pose, with the weight that it and the copy would share.
PoseMode judged(const PoseMode& mode, const LineObservation& found, double outlierWeight) {
  PoseMode result = mode;
  result.weight =
      corrected(mode, found).weight * found.matchFactor + outlierCopy(mode, outlierWeight).weight;
  return result;
}

// A shaken body's lines are all wrong together more often.
double outlierWeightOf(const SeenLines& seen, const LineUpdateParams& params) {
  const double share = std::min(1.0, seen.shaking);
  return params.outlierWeight + share * (params.shakenOutlierWeight - params.outlierWeight);
}

// From 1 at a full match to `refused` at the least that is accepted.
double matchFactorOf(double match, double least, double refused) {
  const double doubt = maths::clamp((1.0 - match) / std::max(1.0 - least, 1e-6), 0.0, 1.0);
  return maths::exp(doubt * maths::log(std::max(refused, 1e-6)));
}

// The weight is exp(-0.5 chi squared) of three degrees of freedom.
double squaredInnovation(double weightFactor) { return -2.0 / 3.0 * maths::log(weightFactor); }

}  // namespace

PoseMode corrected(const PoseMode& mode, const LineObservation& seen) {
  Vector5 off = Vector5::Zero();
  off(0) = seen.pose.pose.position.x - mode.pose.position.x;
  off(1) = seen.pose.pose.position.y - mode.pose.position.y;
  off(2) = (seen.pose.pose.heading - mode.pose.heading).rad();
  off.tail<2>() = tiltMeanOf(seen.tilt) - tiltMeanOf(mode.tilt);
  Vector5 pull = seen.information * off;
  const double squared = off.dot(pull) + 2.0 * off.tail<2>().dot(seen.tiltPull);
  pull.tail<2>() += seen.tiltPull;
  const Matrix5 before = stateCovarianceOf(mode);
  const Matrix5 sum = Matrix5::Identity() + before * seen.information;
  const Matrix5 after = sum.inverse() * before;
  const Vector5 shift = after * pull;
  PoseMode result = mode;
  result.weight *= maths::exp(-0.5 * std::max(0.0, squared - pull.dot(shift)));
  setState(result, stateOf(mode) + shift, after);
  return result;
}

std::optional<LineObservation> observationOf(const LineFit& fit, const FieldFeatures& field,
                                             double headSpeed, const LineUpdateParams& params) {
  const double moving = params.headSpeed * headSpeed;
  const double away = field.outside(fit.pose.position).value;
  const double inside = maths::exp(-params.offField * away * away);
  const double match = fit.match * inside;
  const double least = params.match + params.matchStill / (1.0 + moving);
  if (match < least) return std::nullopt;
  const double share = 1.0 / (1.0 + moving * moving);
  LineObservation observation;
  observation.pose.pose = fit.pose;
  observation.pose.information = floored<3>(fit.information * share, params);
  observation.tilt = fit.tilt;
  observation.information = floored<5>(fit.jointInformation * share, params);
  observation.tiltPull = fit.tiltPull * share;
  observation.matchFactor = matchFactorOf(match, least, params.refusedWeight);
  return observation;
}

std::optional<LineObservation> observationAt(const PoseMode& mode, const SeenLines& seen,
                                             const FieldFeatures& field,
                                             const LineUpdateParams& params, GpsCounts& counts) {
  if (!isNarrow(mode, params)) return std::nullopt;
  const LineFit fit =
      fitLinesAndTilt(seen, mode.pose, mode.tilt, field, params, isUnsure(mode, params));
  auto observation = observationOf(fit, field, seen.headSpeed, params);
  if (!observation) count(Refusal::linesMatchNothing, counts);
  if (!observation) return observation;
  const double share = seen.newEvidenceShare / seen.noiseScale;
  observation->pose.information *= share;
  observation->information *= share;
  observation->tiltPull *= share;
  observation->matchFactor = 1.0 - seen.newEvidenceShare * (1.0 - observation->matchFactor);
  blurByLag(seen.lateVariance, *observation);
  return observation;
}

double weightWithoutLineFit(const PoseMode& mode, const SeenLines& seen,
                            const LineUpdateParams& params) {
  const double kept = isNarrow(mode, params) ? params.refusedWeight : kWideWeight;
  return 1.0 - seen.newEvidenceShare * (1.0 - kept);
}

std::optional<double> updateByLines(const SeenLines& seen, const FieldFeatures& field,
                                    const LineUpdateParams& params, Modes& modes,
                                    GpsCounts& counts) {
  if (seen.lines.size() < params.minPoints) return std::nullopt;
  const Observations found = observationsAt(seen, field, params, modes, counts);
  // Lines that fit no mode are false for all: modes with a failed fit must not lose weight against
  // modes without a fit.
  if (std::none_of(found.begin(), found.end(), [](const auto& o) { return o.has_value(); }))
    return std::nullopt;
  const double weightBefore = modes[0].weight;
  const double outliers = outlierWeightOf(seen, params);
  const std::size_t before = modes.size();
  for (std::size_t i = 0; i < before; ++i) {
    if (i >= found.size() || !found[i]) {
      modes[i].weight *= weightWithoutLineFit(modes[i], seen, params);
      continue;
    }
    if (params.use == LineUse::sanity) {
      modes[i] = judged(modes[i], *found[i], outliers);
      continue;
    }
    modes.push_back(outlierCopy(modes[i], outliers));
    modes[i] = corrected(modes[i], *found[i]);
    modes[i].weight *= found[i]->matchFactor;
  }
  const double fitted = found[0] ? found[0]->matchFactor : 1.0;
  return squaredInnovation(modes[0].weight / (weightBefore * fitted));
}

}  // namespace kelpie::gps
