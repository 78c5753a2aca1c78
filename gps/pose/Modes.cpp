// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/Modes.h"

#include <algorithm>
#include <cmath>

#include "gps/Gaussian.h"
#include "gps/Refusal.h"
#include "gps/pose/Outliers.h"
#include "gps/pose/PoseUpdate.h"

namespace kelpie::gps {
namespace {

constexpr double kDegrees = 180.0 / maths::kPi;

bool finite(const PoseMode& mode) {
  const Vector3 mean = meanOf(mode);
  const Matrix3 c = covarianceOf(mode);
  return std::isfinite(mode.weight) && mode.weight >= 0.0 && mean.allFinite() && c.allFinite() &&
         c(0, 0) > 0.0 && c(1, 1) > 0.0 && c(2, 2) > 0.0;
}

void removeBroken(Modes& modes, GpsCounts& counts) {
  if (std::all_of(modes.begin(), modes.end(), finite)) return;
  Modes kept;
  for (const PoseMode& mode : modes) {
    if (finite(mode)) {
      kept.push_back(mode);
    } else {
      count(Refusal::modeNotFinite, counts);
    }
  }
  modes = kept;
}

bool normalise(Modes& modes) {
  double total = 0.0;
  for (const PoseMode& mode : modes) total += mode.weight;
  if (!(total > 0.0) || !std::isfinite(total)) return false;
  for (PoseMode& mode : modes) mode.weight /= total;
  return true;
}

// Largest difference of the covariances, heading in degrees so that one threshold fits all.
double covarianceDifference(const PoseMode& a, const PoseMode& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < 9; ++i) {
    const double scale = (i / 3 == 2 ? kDegrees : 1.0) * (i % 3 == 2 ? kDegrees : 1.0);
    largest = std::max(largest, scale * std::fabs(a.covariance[i] - b.covariance[i]));
  }
  return largest;
}

// Within a square (facts-2005 section 5.1). A circle in it leaves more modes beside each other: of
// 2400 standing robots two more lost their place.
bool near(const PoseMode& a, const PoseMode& b, double max) {
  const Point2<Field> d = a.pose.position - b.pose.position;
  return std::fabs(d.x) <= max && std::fabs(d.y) <= max &&
         (a.pose.heading - b.pose.heading).abs().deg() <= max;
}

bool mergeable(const PoseMode& a, const PoseMode& b, const ModeParams& params) {
  return near(a, b, params.mergeDistance) && covarianceDifference(a, b) <= params.mergeCovariance;
}

void mergeAll(Modes& modes, const ModeParams& params) {
  for (std::size_t i = 0; i < modes.size(); ++i) {
    for (std::size_t j = i + 1; j < modes.size();) {
      if (!mergeable(modes[i], modes[j], params)) {
        ++j;
        continue;
      }
      modes[i] = merged(modes[i], modes[j]);
      modes[j] = modes.back();
      modes.resize(modes.size() - 1);
    }
  }
}

// Insertion sort: stable, and the list is nearly sorted already.
void sortByWeight(Modes& modes) {
  for (std::size_t i = 1; i < modes.size(); ++i) {
    const PoseMode mode = modes[i];
    std::size_t j = i;
    for (; j > 0 && modes[j - 1].weight < mode.weight; --j) modes[j] = modes[j - 1];
    modes[j] = mode;
  }
}

// The pose at the angle `around` of the landmark, and how it varies with the three things it was
// made of: distance, heading and that angle.
PoseMode seed(const Measurement& m, double around, double aroundSd, double maxSd) {
  const Angle out = Angle::rad(around);
  PoseMode mode;
  mode.weight = 1.0;
  mode.pose.position = m.landmark + Point2<Field>{out.cos(), out.sin()} * m.distance;
  mode.pose.heading = out + Angle::rad(maths::kPi) - m.heading;
  Matrix3 j;
  j << out.cos(), 0, -m.distance * out.sin(), out.sin(), 0, m.distance * out.cos(), 0, -1, 1;
  // A heading alone says little about the distance that came with it.
  const double distanceFactor = m.useDistance ? 1.0 : 4.0;
  const double headingFactor = m.useHeading ? 1.0 : 16.0;
  // A distance that says nothing must not make a mode wider than the field allows.
  const double distanceVariance = std::min(m.distanceVariance, maths::square(maxSd));
  const Vector3 variances(distanceFactor * distanceVariance, headingFactor * m.headingVariance,
                          aroundSd * aroundSd);
  setCovariance(mode, j * variances.asDiagonal() * j.transpose());
  return mode;
}

}  // namespace

// What is known of the body holds wherever it stands.
CameraTilt tiltOf(const Modes& modes) { return modes.empty() ? CameraTilt{} : modes[0].tilt; }

PoseMode wideMode(const body::FieldDescription& field, const ModeParams& params, double weight) {
  PoseMode mode;
  mode.weight = weight;
  mode.pose.position = {0.5 * field.width, 0.5 * field.length};
  mode.pose.heading = Angle::deg(90.0);
  const double position = maths::square(params.widePositionSd);
  mode.covariance = {
      position, 0, 0, 0, position, 0, 0, 0, maths::square(params.wideHeadingSd.rad())};
  return mode;
}

void start(const InitialPose& initial, const body::FieldDescription& field,
           const ModeParams& params, PoseState& state) {
  lose(field, params, state);
  state.started = true;
  if (!initial.present) return;
  const double position = maths::square(initial.positionSd);
  state.modes[0].pose = initial.pose;
  state.modes[0].covariance = {
      position, 0, 0, 0, position, 0, 0, 0, maths::square(initial.headingSd.rad())};
  state.lost = false;
}

void lose(const body::FieldDescription& field, const ModeParams& params, PoseState& state) {
  PoseMode wide = wideMode(field, params, 1.0);
  wide.tilt = tiltOf(state.modes);
  state.modes.clear();
  state.modes.push_back(wide);
  state.lost = true;
}

void seedAround(const Measurement& measurement, const body::FieldDescription& field,
                const ModeParams& params, PoseState& state, GpsCounts& counts) {
  const double spacing = params.seedSpacing / kDegrees;
  const int number = static_cast<int>(2.0 * maths::kPi / spacing + 0.5);
  const CameraTilt tilt = tiltOf(state.modes);
  Modes seeds;
  for (int i = 0; i < number; ++i) {
    PoseMode mode = seed(measurement, (i + 0.5) * spacing, 0.5 * spacing, params.widePositionSd);
    mode.tilt = tilt;
    if (body::carpetDistance(field, mode.pose.position) <= 0.0) seeds.push_back(mode);
  }
  if (seeds.empty()) {
    count(Refusal::seedOffField, counts);
    return;
  }
  state.modes = seeds;
  state.lost = false;
}

void updateAll(const Measurement& measurement, const body::FieldDescription& field,
               const ModeParams& params, PoseState& state, GpsCounts& counts) {
  Modes& modes = state.modes;
  if (params.wideWeight > 0.0) {
    PoseMode wide = wideMode(field, params, params.wideWeight);
    wide.tilt = tiltOf(modes);
    modes.push_back(wide);
  }
  const std::size_t before = modes.size();
  const double outlierWeight = outlierWeightOf(measurement.kind, params, state.sightings);
  SplitWeights weights;
  for (std::size_t i = 0; i < before; ++i) {
    if (i == 0 && atGrazingAngle(modes[i], measurement)) count(Refusal::goalTooOblique, counts);
    modes.push_back(outlierCopy(modes[i], outlierWeight));
    modes[i] = correctedByLandmark(modes[i], measurement);
    weights.copies += modes.back().weight;
    weights.corrected += modes[i].weight;
  }
  note(weights, state.sightings[static_cast<std::size_t>(measurement.kind)]);
  // The wide mode alone is not enough: near modes crowd it out, and it cannot be linearised well.
  countUnexplainedLandmarks(weights, params, 1, state);
}

void mergeAndPrune(const body::FieldDescription& field, const ModeParams& params, PoseState& state,
                   GpsCounts& counts) {
  removeBroken(state.modes, counts);
  mergeAll(state.modes, params);
  sortByWeight(state.modes);
  state.modes.resize(std::min(state.modes.size(), kMaxModes));
  if (!state.modes.empty() && normalise(state.modes)) return;
  lose(field, params, state);
}

PoseMode merged(const PoseMode& a, const PoseMode& b) {
  const double total = a.weight + b.weight;
  const double shareB = total > 0.0 ? b.weight / total : 0.5;
  Vector5 apart = stateOf(b) - stateOf(a);
  apart(2) = (b.pose.heading - a.pose.heading).rad();  // the short way round
  PoseMode mode;
  mode.weight = total;
  setState(mode, stateOf(a) + shareB * apart,
           (1.0 - shareB) * stateCovarianceOf(a) + shareB * stateCovarianceOf(b) +
               shareB * (1.0 - shareB) * apart * apart.transpose());
  return mode;
}

}  // namespace kelpie::gps
