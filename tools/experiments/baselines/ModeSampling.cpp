// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/baselines/ModeSampling.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gps/pose/PoseUpdate.h"

namespace kelpie::gps {
namespace {

constexpr double kMinCurvature = 1e-9;  // below it the values do not bend down
constexpr double kMinSd = 1e-3;         // cm, rad: what can be inverted
constexpr std::size_t kMaxPeaks = 4;    // of one mode

struct Samples {
  std::array<double, 27> values{};
  std::array<double, 3> spacing{};  // cm, cm, rad: the mode's own standard deviations

  double at(int i, int j, int k) const {
    return values[static_cast<std::size_t>(9 * (i + 1) + 3 * (j + 1) + k + 1)];
  }
};

Samples sampled(const PoseMode& mode, const SeenLines& seen, const FieldFeatures& field,
                const LineUpdateParams& params) {
  Samples samples;
  for (std::size_t axis = 0; axis < 3; ++axis)
    samples.spacing[axis] = std::sqrt(mode.covariance[4 * axis]);
  std::size_t index = 0;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k) {
        const Vector3 shift(i * samples.spacing[0], j * samples.spacing[1], k * samples.spacing[2]);
        samples.values[index++] = lineMatch(seen, poseOf(meanOf(mode) + shift), field, params);
      }
  return samples;
}

// Values along one axis through a sample: what lies beyond the grid is absent.
using Along = std::array<std::optional<double>, 3>;

Along along(const Samples& samples, std::array<int, 3> place, std::size_t axis) {
  Along values;
  for (int step = -1; step <= 1; ++step) {
    std::array<int, 3> p = place;
    p[axis] += step;
    if (p[axis] < -1 || p[axis] > 1) continue;
    values[static_cast<std::size_t>(step + 1)] = samples.at(p[0], p[1], p[2]);
  }
  return values;
}

bool isPeak(const Samples& samples, std::array<int, 3> place) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Along values = along(samples, place, axis);
    for (const std::optional<double> other : {values[0], values[2]})
      if (other && *other > *values[1]) return false;
  }
  return true;
}

std::optional<Gaussian1d> fitAlong(const Along& values) {
  if (values[0] && values[2]) return fitPeak(*values[0], *values[1], *values[2]);
  const bool upper = values[0].has_value();
  auto peak = fitEdgePeak(upper ? *values[0] : *values[2], *values[1]);
  if (peak) peak->mean = 0.0;  // seen from the edge's own place
  return peak;
}

// A flat axis says nothing: its information is zero.
PoseObservation observationOf(const Samples& samples, std::array<int, 3> place,
                              const PoseMode& mode, const SamplingFloor& floor) {
  PoseObservation observation;
  observation.information = Matrix3::Zero();
  Vector3 mean = meanOf(mode);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto index = static_cast<Eigen::Index>(axis);
    mean(index) += place[axis] * samples.spacing[axis];
    const auto peak = fitAlong(along(samples, place, axis));
    if (!peak) continue;
    mean(index) += peak->mean * samples.spacing[axis];
    const double min = axis == 2 ? floor.headingSd.rad() : floor.sd;
    const double sd = std::max({peak->sd * samples.spacing[axis], min, kMinSd});
    observation.information(index, index) = 1.0 / (sd * sd);
  }
  observation.pose = poseOf(mean);
  return observation;
}

// The mode corrected by each peak of the match around it.
void addCorrected(const PoseMode& mode, const Samples& samples, const SamplingFloor& floor,
                  Modes& modes) {
  std::size_t peaks = 0;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k) {
        if (peaks >= kMaxPeaks || !isPeak(samples, {i, j, k})) continue;
        PoseMode moved = corrected(mode, observationOf(samples, {i, j, k}, mode, floor));
        moved.weight *= samples.at(i, j, k);
        modes.push_back(moved);
        ++peaks;
      }
}

}  // namespace

std::optional<Gaussian1d> fitPeak(double before, double here, double after) {
  if (!(before > 0.0 && here > 0.0 && after > 0.0)) return std::nullopt;
  const double q = maths::log(here * here / (before * after));
  if (q < kMinCurvature) return std::nullopt;
  const double r = maths::log(here * here / (after * after));
  return Gaussian1d{0.5 - r / (2.0 * q), 1.0 / std::sqrt(q)};
}

std::optional<Gaussian1d> fitEdgePeak(double inside, double edge) {
  if (!(inside > 0.0 && edge > 0.0)) return std::nullopt;
  const double s = maths::log(edge * edge / (inside * inside));
  if (s < kMinCurvature) return std::nullopt;
  return Gaussian1d{1.0, 1.0 / std::sqrt(s)};
}

bool updateBySampling(const SeenLines& seen, const SamplingFloor& floor, const FieldFeatures& field,
                      const LineUpdateParams& params, Modes& modes) {
  if (seen.lines.size() < params.minPoints) return false;
  const Modes before = modes;
  // Room for the copies first: the peaks of light modes are what may be left out.
  for (PoseMode& mode : modes) mode.weight *= params.outlierWeight;
  for (const PoseMode& mode : before)
    addCorrected(mode, sampled(mode, seen, field, params), floor, modes);
  return true;
}

}  // namespace kelpie::gps
