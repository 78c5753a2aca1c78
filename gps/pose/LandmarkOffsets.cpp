// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/LandmarkOffsets.h"

#include <algorithm>
#include <cmath>

#include "gps/Refusal.h"
#include "gps/pose/PoseUpdate.h"

namespace kelpie::gps {
namespace {

constexpr double kNearest = 10.0;  // cm

Matrix2 covarianceOf(const LandmarkOffset& offset) {
  Matrix2 matrix;
  matrix << offset.xx, offset.xy, offset.xy, offset.yy;
  return matrix;
}

void setCovariance(LandmarkOffset& offset, const Matrix2& matrix) {
  offset.xx = matrix(0, 0);
  offset.xy = 0.5 * (matrix(0, 1) + matrix(1, 0));
  offset.yy = matrix(1, 1);
}

template <class Offsets>
auto& of(LandmarkKind kind, Offsets& offsets) {
  return offsets.landmarks[static_cast<std::size_t>(kind)];
}

bool narrow(const PoseMode& mode, double maxSd) {
  return mode.covariance[0] + mode.covariance[4] <= 2.0 * maths::square(maxSd);
}

// By one number that was seen, of which `slope` is what the landmark's own way does to it, and
// `others` the variance of all but its offset.
void correct(double innovation, const Vector2& slope, double others, double gate,
             LandmarkOffset& offset) {
  const Matrix2 covariance = covarianceOf(offset);
  const Vector2 shared = covariance * slope;
  const double variance = slope.dot(shared) + others;
  if (!(innovation * innovation <= gate * gate * variance)) return;
  const Vector2 gain = shared / variance;
  offset.x += gain(0) * innovation;
  offset.y += gain(1) * innovation;
  setCovariance(offset, covariance - gain * shared.transpose());
}

}  // namespace

LandmarkOffsets startingOffsets(const LandmarkOffsetParams& params) {
  LandmarkOffsets offsets;
  if (!params.use) return offsets;
  for (LandmarkOffset& one : offsets.landmarks) one.xx = one.yy = maths::square(params.sd);
  return offsets;
}

void driftOffsets(TeamColour team, double elapsed, const LandmarkOffsetParams& params,
                  LandmarkOffsets& offsets) {
  if (!params.use) return;
  if (team != offsets.team) offsets = startingOffsets(params);
  offsets.team = team;
  const double settled = maths::square(params.sd);
  const double kept = maths::exp(-0.5 * elapsed * maths::square(params.drift) / settled);
  for (LandmarkOffset& one : offsets.landmarks) {
    for (double* mean : {&one.x, &one.y}) *mean *= kept;
    for (double* covariance : {&one.xx, &one.xy, &one.yy}) *covariance *= kept * kept;
    for (double* variance : {&one.xx, &one.yy}) *variance += (1.0 - kept * kept) * settled;
  }
}

Measurement displaced(const Measurement& seen, const LandmarkOffsetParams& params,
                      const LandmarkOffsets& offsets) {
  Measurement m = seen;
  if (!params.use) return m;
  const LandmarkOffset& offset = of(seen.kind, offsets);
  m.landmark = seen.landmark + Point2<Field>{offset.x, offset.y};
  return m;
}

Measurement doubted(const Measurement& seen, const LandmarkOffsets& offsets) {
  Measurement m = seen;
  const LandmarkOffset& offset = of(seen.kind, offsets);
  const double variance = 0.5 * (offset.xx + offset.yy);
  const double turned = variance / maths::square(std::max(seen.distance, kNearest));
  m.distanceVariance += variance;
  m.headingVariance += turned;
  m.grazingHeadingVariance += turned;
  return m;
}

void learnOffset(const PoseMode& best, const Measurement& seen, const LandmarkOffsetParams& params,
                 LandmarkOffsets& offsets, GpsCounts& counts) {
  if (!params.use || !narrow(best, params.maxSd) || atGrazingAngle(best, seen)) return;
  LandmarkOffset& offset = of(seen.kind, offsets);
  const Expectation e = expected(best.pose, seen.landmark);
  const Vector3 distance(e.jacobian[0], e.jacobian[1], e.jacobian[2]);
  const Vector3 heading(e.jacobian[3], e.jacobian[4], e.jacobian[5]);
  const Matrix3 pose = covarianceOf(best);
  const auto spread = [&pose](const Vector3& h) { return h.dot(pose * h); };
  if (seen.useDistance)
    correct(seen.distance - e.distance, -distance.head<2>(),
            spread(distance) + seen.distanceVariance, params.gate, offset);
  if (seen.useHeading)
    correct((seen.heading - e.heading).rad(), -heading.head<2>(),
            spread(heading) + seen.headingVariance, params.gate, offset);
  offset.x = maths::clamp(offset.x, -params.max, params.max);
  offset.y = maths::clamp(offset.y, -params.max, params.max);
  if (maths::hypot(offset.x, offset.y) > params.moved) count(Refusal::landmarkMoved, counts);
}

}  // namespace kelpie::gps
