// SPDX-License-Identifier: Apache-2.0
#include "gps/lines/LineFit.h"

#include <algorithm>
#include <cmath>

namespace kelpie::gps {
namespace {

constexpr double kLever = 100.0;  // cm: a turn's damping in the units of a step's
constexpr double kFirstDamping = 0.01;
constexpr double kStepTolerance = 0.05;  // cm
constexpr double kTurnTolerance = 5e-4;  // rad

// Sums over the points at one pose: match, and the normal equations of the reweighted distances.
struct Sums {
  double weight = 0.0;
  double match = 0.0;
  Matrix3 curvature = Matrix3::Zero();
  Vector3 gradient = Vector3::Zero();

  double share() const { return weight > 0.0 ? match / weight : 1.0; }
};

struct Turned {
  Pose2 pose;
  double sin;
  double cos;
};

Turned turned(const Pose2& pose) { return {pose, pose.heading.sin(), pose.heading.cos()}; }

// Thesis 2004 equation 3.12 with heading 90 deg up the field.
Point2<Field> placed(const Turned& t, Point2<Robot> p) {
  return {t.pose.position.x + t.sin * p.x + t.cos * p.y,
          t.pose.position.y - t.cos * p.x + t.sin * p.y};
}

template <typename Points, typename Distance>
Sums summed(const Points& points, const Turned& t, double sharpness, const Distance& distance) {
  Sums sums;
  for (const SeenPoint& point : points) {
    const FeatureDistance d = distance(placed(t, point.place), point.border);
    const double value = 1.0 / (1.0 + sharpness * d.value * d.value);
    sums.weight += point.weight;
    sums.match += point.weight * value;
    const double spin = d.alongX * (t.cos * point.place.x - t.sin * point.place.y) +
                        d.alongY * (t.sin * point.place.x + t.cos * point.place.y);
    const Vector3 slope(d.alongX, d.alongY, spin);
    const double weight = point.weight * value * value;
    sums.gradient += weight * d.value * slope;
    sums.curvature += weight * slope * slope.transpose();
  }
  return sums;
}

struct Evaluation {
  double match = 0.0;
  Matrix3 curvature;
  Vector3 gradient;
};

Evaluation evaluate(const SeenLines& seen, const Pose2& pose, const FieldFeatures& field,
                    const LineUpdateParams& params) {
  const Turned t = turned(pose);
  const double s = params.sharpness;
  const Sums lines = summed(seen.lines, t, s, [&field](Point2<Field> p, bool border) {
    return border ? field.border(p) : field.nearest(p);
  });
  const Sums carpet =
      summed(seen.carpet, t, s, [&field](Point2<Field> p, bool) { return field.outside(p); });
  return {lines.share() * carpet.share(), lines.curvature + carpet.curvature,
          lines.gradient + carpet.gradient};
}

Vector3 stepOf(const Evaluation& e, double damping, const LineUpdateParams& params) {
  Matrix3 damped = e.curvature;
  const double scale = damping * std::max(e.curvature(0, 0) + e.curvature(1, 1), 1e-6);
  damped.diagonal() += scale * Vector3(1.0, 1.0, kLever * kLever);
  Vector3 step = -damped.inverse() * e.gradient;
  const double far = maths::hypot(step(0), step(1));
  const double shrink =
      std::max({1.0, far / params.farStep, std::fabs(step(2)) / params.farTurn.rad()});
  return step / shrink;
}

bool usable(const LinePoint& p) {
  return std::isfinite(p.position.x) && std::isfinite(p.position.y) && p.weight > 0.0 &&
         p.weight <= 1.0;
}

template <typename Kept>
void thin(const FixedVector<LinePoint, 256>& points, LinePointKind kind, std::size_t most,
          Kept& kept) {
  std::size_t count = 0;
  for (const LinePoint& p : points) count += p.kind == kind && usable(p) ? 1 : 0;
  std::size_t index = 0;
  for (const LinePoint& p : points) {
    if (p.kind != kind || !usable(p)) continue;
    if (isSpread(index++, count, most))
      kept.push_back({p.position, p.weight, kind == LinePointKind::border});
  }
}

// Damped steps from the fit's pose, which moves to the best found; returns what holds there.
Evaluation climb(const SeenLines& seen, const FieldFeatures& field, const LineUpdateParams& params,
                 LineFit& fit) {
  Evaluation here = evaluate(seen, fit.pose, field, params);
  double damping = kFirstDamping;
  ++fit.steps;
  for (std::uint32_t i = 1; i < params.maxSteps; ++i, ++fit.steps) {
    const Vector3 step = stepOf(here, damping, params);
    const Pose2 next{{fit.pose.position.x + step(0), fit.pose.position.y + step(1)},
                     fit.pose.heading + Angle::rad(step(2))};
    const Evaluation there = evaluate(seen, next, field, params);
    if (there.match < here.match) {
      damping *= 8.0;
      continue;
    }
    fit.pose = next;
    here = there;
    damping *= 0.2;
    if (maths::hypot(step(0), step(1)) < kStepTolerance && std::fabs(step(2)) < kTurnTolerance)
      break;
  }
  return here;
}

}  // namespace

SeenLines seenLines(const FixedVector<LinePoint, 256>& points, const LineUpdateParams& params) {
  SeenLines seen;
  const auto most = std::min<std::size_t>(params.maxPoints, kMaxLinePoints);
  thin(points, LinePointKind::line, most, seen.lines);
  thin(points, LinePointKind::border, most, seen.lines);
  thin(points, LinePointKind::field, 12, seen.carpet);
  return seen;
}

double lineMatch(const SeenLines& seen, const Pose2& pose, const FieldFeatures& field,
                 const LineUpdateParams& params) {
  return evaluate(seen, pose, field, params).match;
}

LineFit fitLines(const SeenLines& seen, const Pose2& start, const FieldFeatures& field,
                 const LineUpdateParams& params, bool fromFar) {
  LineFit fit;
  fit.pose = start;
  if (fromFar) {
    LineUpdateParams coarse = params;
    coarse.sharpness *= params.coarseShare;
    climb(seen, field, coarse, fit);
  }
  const Evaluation end = climb(seen, field, params, fit);
  fit.match = end.match;
  fit.information = end.curvature / (params.correlation * maths::square(params.pointSd));
  return fit;
}

}  // namespace kelpie::gps
