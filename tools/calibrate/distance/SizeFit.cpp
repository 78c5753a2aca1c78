// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/distance/SizeFit.h"

#include <algorithm>
#include <cmath>

#include "tools/calibrate/RobustFit.h"

namespace kelpie::calibrate {
namespace {

constexpr std::array<SizedObject, kSizedObjects> kObjects = {SizedObject::ball, SizedObject::beacon,
                                                             SizedObject::goal};
enum SizeUnknown : std::size_t { kFocal, kEdgeOfBall, kEdgeOfBeacon, kEdgeOfGoal, kBlurOfBall };

Optics opticsOf(std::size_t object, const Numbers& values) {
  const bool ball = kObjects[object] == SizedObject::ball;
  return {values[kFocal], values[kEdgeOfBall + object],
          ball ? std::fabs(values[kBlurOfBall]) : 0.0};
}

using Objects = std::array<Measurements, kSizedObjects>;

// Errors of distance in units of what the team's own fit leaves; each object has the same weight in
// all, however often it was measured.
FitProblem problemOf(const Objects& objects) {
  FitProblem problem;
  problem.unknowns = {{192.0, 0.1}, {0.0, 0.01}, {0.0, 0.01}, {0.0, 0.01}, {1.0, 0.01}};
  // An object's share puts single sizes at up to 1.5 times their deviation. From 3 on the focal
  // length stays within 0.1 px; at 2, for sightings where many are wrong, good ones lose weight:
  // 0.7 px less.
  problem.cauchy = 4.0;
  double all = 0.0;
  for (const Measurements& rows : objects) all += static_cast<double>(rows.size());
  Numbers scale;
  int group = 0;
  for (std::size_t i = 0; i < kSizedObjects; ++i) {
    const double share = all / (static_cast<double>(kSizedObjects * objects[i].size()));
    scale.push_back(std::sqrt(share) / misfit(objects[i], teamsFit(kObjects[i])).rms);
    int last = 0;
    for (const Measured& m : objects[i]) {
      problem.groups.push_back(group + m.series);
      last = std::max(last, m.series);
    }
    group += last + 1;
  }
  problem.residuals = [&objects, scale](const Numbers& values, Numbers& residuals) {
    residuals.clear();
    for (std::size_t i = 0; i < kSizedObjects; ++i) {
      const DistanceModel model = geometry(kObjects[i], opticsOf(i, values));
      for (const Measured& m : objects[i]) residuals.push_back(scale[i] * (model(m) - m.distance));
    }
  };
  return problem;
}

}  // namespace

Expected<SizeFit> fitSizes(const std::string& folder) {
  Objects objects;
  for (std::size_t i = 0; i < kSizedObjects; ++i) {
    auto rows = readMeasurements(kObjects[i], folder);
    if (!rows) return Error{rows.error()};
    objects[i] = *rows;
  }
  const Fit fit = robustFit(problemOf(objects));
  if (!fit.converged || !std::isfinite(fit.value[kFocal]) || !std::isfinite(fit.sd[kFocal]))
    return Error{folder + ": no focal length fits these sizes"};
  SizeFit result;
  result.focalLength = fit.value[kFocal];
  result.focalSd = fit.sd[kFocal];
  for (std::size_t i = 0; i < kSizedObjects; ++i) {
    result.optics[i] = opticsOf(i, fit.value);
    result.measured[i] = objects[i].size();
    result.before[i] = misfit(objects[i], geometry(kObjects[i], {}));
    result.after[i] = misfit(objects[i], geometry(kObjects[i], result.optics[i]));
  }
  return result;
}

}  // namespace kelpie::calibrate
