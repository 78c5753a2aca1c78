// SPDX-License-Identifier: Apache-2.0
#include "gps/lines/LineFit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace kelpie::gps {
namespace {

constexpr double kLever = 100.0;  // cm: a turn's damping in the units of a step's
constexpr double kFirstDamping = 0.01;
constexpr double kStepTolerance = 0.3;   // cm; the step after one as small is ten times smaller
constexpr double kTurnTolerance = 2e-3;  // rad, of heading, tilt and roll

// The number of unknowns: x, y and heading, or tilt and roll with them.
constexpr int kPose = 3;
constexpr int kPoseAndTilt = 5;
template <int N>
using Vector = Eigen::Matrix<double, N, 1>;
template <int N>
using Matrix = Eigen::Matrix<double, N, N>;

// Sums over the points: match, and the normal equations of the reweighted distances.
template <int N>
struct Sums {
  double weight = 0.0;
  double match = 0.0;
  std::array<double, N*(N + 1) / 2> lowerHalf{};  // of the curvature, row by row
  Vector<N> gradient = Vector<N>::Zero();

  double share() const { return weight > 0.0 ? match / weight : 1.0; }
  void add(double pointWeight, double distance, const Vector<N>& slope) {
    const Vector<N> weighted = pointWeight * slope;
    gradient += distance * weighted;
    addSquare(weighted, slope, std::make_index_sequence<std::tuple_size_v<decltype(lowerHalf)>>());
  }
  Matrix<N> curvature() const {
    Matrix<N> whole;
    for (int row = 0, k = 0; row < N; ++row)
      for (int column = 0; column <= row; ++column, ++k)
        whole(row, column) = whole(column, row) = lowerHalf[static_cast<std::size_t>(k)];
    return whole;
  }

 private:
  static constexpr int rowOf(std::size_t k) {
    int row = 0;
    while (static_cast<std::size_t>((row + 1) * (row + 2) / 2) <= k) ++row;
    return row;
  }
  static constexpr int columnOf(std::size_t k) {
    return static_cast<int>(k) - rowOf(k) * (rowOf(k) + 1) / 2;
  }
  // Without loops: most of what gps costs is here.
  template <std::size_t... K>
  void addSquare(const Vector<N>& a, const Vector<N>& b, std::index_sequence<K...>) {
    ((lowerHalf[K] += a(rowOf(K)) * b(columnOf(K))), ...);
  }
};

// A place of the fit: the pose, and the tilt beyond that with which the points were laid down.
struct Trial {
  Pose2 pose;
  Vector2 tilt = Vector2::Zero();
};

struct Turned {
  const Trial& trial;
  double sin;
  double cos;

  explicit Turned(const Trial& t) : Turned(t, t.pose.heading.sinCos()) {}
  Turned(const Trial& t, const maths::SinCos& heading)
      : trial(t), sin(heading.sin), cos(heading.cos) {}
  // Thesis 2004 equation 3.12 with heading 90 deg up the field.
  Point2<Field> placed(Point2<Robot> p) const {
    const Point2<Field>& at = trial.pose.position;
    return {at.x + sin * p.x + cos * p.y, at.y - cos * p.x + sin * p.y};
  }
  // How a distance grows when the point moves in the robot frame.
  double along(const FeatureDistance& d, Point2<Robot> way) const {
    return d.alongX * (sin * way.x + cos * way.y) + d.alongY * (sin * way.y - cos * way.x);
  }
};

// Where the ray to a point meets the ground when the camera is turned by a small tilt and roll
// more.
struct Relaid {
  bool onGround = true;
  Point2<Robot> place;
  Point2<Robot> way;  // from below the camera
  double height = 0.0;

  Point2<Robot> perTilt() const {
    return {way.x * way.y / height, height + way.y * way.y / height};
  }
  Point2<Robot> perRoll() const {
    return {-height - way.x * way.x / height, -(way.x * way.y / height)};
  }
};

Relaid relaid(const Point3<Robot>& eye, Point2<Robot> place, const Vector2& tilt) {
  constexpr double kFlattest = 0.05;  // of the eye's height: 20 times as far
  const double h = eye.z;
  const double x = place.x - eye.x;
  const double y = place.y - eye.y;
  const double down = h - tilt(0) * y + tilt(1) * x;
  if (!(down > kFlattest * h)) return {false, {}, {}, h};
  const double stretch = h / down;
  const Point2<Robot> way{(x - tilt(1) * h) * stretch, (y + tilt(0) * h) * stretch};
  return {true, {eye.x + way.x, eye.y + way.y}, way, h};
}

template <int N, typename Points, typename Distance>
Sums<N> summed(const Points& points, const Point3<Robot>& eye, const Turned& t, double sharpness,
               const Distance& distance) {
  Sums<N> sums;
  for (const SeenPoint& point : points) {
    sums.weight += point.weight;
    Relaid at{true, point.place, {}, 0.0};
    if constexpr (N == kPoseAndTilt) at = relaid(eye, point.place, t.trial.tilt);
    if (!at.onGround) continue;
    const FeatureDistance d = distance(t.placed(at.place), point.border);
    const double value = 1.0 / (1.0 + sharpness * d.value * d.value);
    sums.match += point.weight * value;
    if (d.alongX == 0.0 && d.alongY == 0.0) continue;  // green on the carpet pulls nowhere
    Vector<N> slope;
    slope(0) = d.alongX;
    slope(1) = d.alongY;
    slope(2) = t.along(d, {-at.place.y, at.place.x});
    if constexpr (N == kPoseAndTilt) {
      slope(3) = t.along(d, at.perTilt());
      slope(4) = t.along(d, at.perRoll());
    }
    sums.add(point.weight * value * value, d.value, slope);
  }
  return sums;
}

// What is known of the tilt beforehand, in the units of the normal equations.
struct TiltPrior {
  Vector2 mean = Vector2::Zero();
  Matrix2 information = Matrix2::Zero();
};

// `score` is the match less what an unlikely tilt costs.
template <int N>
struct Evaluation {
  double match = 0.0;
  double score = 0.0;
  Matrix<N> curvature;
  Vector<N> gradient;
};

struct View {
  const SeenLines& seen;
  const FieldFeatures& field;
  const LineUpdateParams& params;
  TiltPrior prior;
};

template <int N>
Evaluation<N> evaluate(const View& view, const Trial& trial) {
  const Turned t(trial);
  const double s = view.params.sharpness;
  const FieldFeatures& field = view.field;
  const Point3<Robot>& eye = view.seen.eye;
  const Sums<N> lines =
      summed<N>(view.seen.lines, eye, t, s, [&field](Point2<Field> p, bool border) {
        return border ? field.border(p) : field.nearest(p);
      });
  const Sums<N> carpet = summed<N>(view.seen.carpet, eye, t, s,
                                   [&field](Point2<Field> p, bool) { return field.outside(p); });
  Evaluation<N> e;
  e.match = lines.share() * carpet.share();
  e.score = e.match;
  e.curvature = lines.curvature() + carpet.curvature();
  e.gradient = lines.gradient + carpet.gradient;
  if constexpr (N == kPoseAndTilt) {
    const Vector2 off = trial.tilt - view.prior.mean;
    const Vector2 pull = view.prior.information * off;
    e.score -= off.dot(pull) * s / std::max(lines.weight, 1e-6);
    e.gradient.template tail<2>() += pull;
    e.curvature.template bottomRightCorner<2, 2>() += view.prior.information;
  }
  return e;
}

template <int N>
Vector<N> stepOf(const Evaluation<N>& e, double damping, const LineUpdateParams& params) {
  Matrix<N> damped = e.curvature;
  const double scale = damping * std::max(e.curvature(0, 0) + e.curvature(1, 1), 1e-6);
  for (int i = 0; i < N; ++i) damped(i, i) += scale * (i < 2 ? 1.0 : kLever * kLever);
  Vector<N> step = -damped.llt().solve(e.gradient);
  const double far = maths::hypot(step(0), step(1));
  const double shrink =
      std::max({1.0, far / params.farStep, std::fabs(step(2)) / params.farTurn.rad()});
  return step / shrink;
}

template <int N>
Trial stepped(const Trial& from, const Vector<N>& step) {
  Trial to = from;
  to.pose = {{from.pose.position.x + step(0), from.pose.position.y + step(1)},
             from.pose.heading + Angle::rad(step(2))};
  if constexpr (N == kPoseAndTilt) to.tilt += step.template tail<2>();
  return to;
}

template <int N>
bool isSmall(const Vector<N>& step) {
  return maths::hypot(step(0), step(1)) < kStepTolerance &&
         step.template tail<N - 2>().cwiseAbs().maxCoeff() < kTurnTolerance;
}

// Damped steps from the trial, which moves to the best found; returns what holds there.
template <int N>
Evaluation<N> climb(const View& view, Trial& trial, std::uint32_t& steps) {
  Evaluation<N> here = evaluate<N>(view, trial);
  double damping = kFirstDamping;
  ++steps;
  for (std::uint32_t i = 1; i < view.params.maxSteps; ++i, ++steps) {
    const Vector<N> step = stepOf<N>(here, damping, view.params);
    const Trial next = stepped<N>(trial, step);
    const Evaluation<N> there = evaluate<N>(view, next);
    if (there.score < here.score) {
      damping *= 8.0;
      continue;
    }
    trial = next;
    here = there;
    damping *= 0.2;
    if (isSmall<N>(step)) break;
  }
  return here;
}

template <int N>
Evaluation<N> climbed(const View& view, bool fromFar, Trial& trial, std::uint32_t& steps) {
  if (fromFar) {
    LineUpdateParams coarse = view.params;
    coarse.sharpness *= coarse.coarseShare;
    climb<N>({view.seen, view.field, coarse, view.prior}, trial, steps);
  }
  return climb<N>(view, trial, steps);
}

// The points' variance, as far as they tell different things.
double varianceOf(const LineUpdateParams& params) {
  return params.correlation * maths::square(params.pointSd);
}

bool usable(const LinePoint& p) {
  return std::isfinite(p.position.x) && std::isfinite(p.position.y) && p.weight > 0.0 &&
         p.weight <= 1.0;
}

template <typename Kept>
void thin(const FixedVector<LinePoint, 256>& points, LinePointKind kind, std::size_t max,
          Kept& kept) {
  std::size_t count = 0;
  for (const LinePoint& p : points) count += p.kind == kind && usable(p) ? 1 : 0;
  std::size_t index = 0;
  for (const LinePoint& p : points) {
    if (p.kind != kind || !usable(p)) continue;
    if (isSpread(index++, count, max))
      kept.push_back({p.position, p.weight, kind == LinePointKind::border});
  }
}

}  // namespace

SeenLines seenLines(const FixedVector<LinePoint, 256>& points, const LineUpdateParams& params) {
  SeenLines seen;
  const auto max = std::min<std::size_t>(params.maxPoints, kMaxLinePoints);
  thin(points, LinePointKind::line, max, seen.lines);
  thin(points, LinePointKind::border, max, seen.lines);
  thin(points, LinePointKind::field, 12, seen.carpet);
  return seen;
}

double lineMatch(const SeenLines& seen, const Pose2& pose, const FieldFeatures& field,
                 const LineUpdateParams& params) {
  return evaluate<kPose>({seen, field, params, {}}, {pose}).match;
}

LineFit fitLines(const SeenLines& seen, const Pose2& start, const FieldFeatures& field,
                 const LineUpdateParams& params, bool fromFar) {
  LineFit fit;
  Trial trial{start};
  const auto end = climbed<kPose>({seen, field, params, {}}, fromFar, trial, fit.steps);
  fit.pose = trial.pose;
  fit.match = end.match;
  fit.information = end.curvature / varianceOf(params);
  fit.tilt = seen.readWith;
  fit.jointInformation = Matrix5::Zero();
  fit.jointInformation.topLeftCorner<3, 3>() = fit.information;
  fit.tiltPull = Vector2::Zero();
  return fit;
}

LineFit fitLinesAndTilt(const SeenLines& seen, const Pose2& start, const CameraTilt& known,
                        const FieldFeatures& field, const LineUpdateParams& params, bool fromFar) {
  const double variance = varianceOf(params);
  const Vector2 readWith = tiltMeanOf(seen.readWith);
  const TiltPrior prior{tiltMeanOf(known) - readWith, variance * tiltCovarianceOf(known).inverse()};
  LineFit fit;
  Trial trial{start, prior.mean};
  const auto end = climbed<kPoseAndTilt>({seen, field, params, prior}, fromFar, trial, fit.steps);
  fit.pose = trial.pose;
  fit.match = end.match;
  fit.tilt = known;
  fit.tilt.tilt = Angle::rad(readWith(0) + trial.tilt(0));
  fit.tilt.roll = Angle::rad(readWith(1) + trial.tilt(1));
  const Matrix32 cross = end.curvature.topRightCorner<3, 2>();
  const Matrix2 tiltCurvature = end.curvature.bottomRightCorner<2, 2>();
  fit.information =
      (end.curvature.topLeftCorner<3, 3>() - cross * tiltCurvature.inverse() * cross.transpose()) /
      variance;
  fit.jointInformation = end.curvature / variance;
  fit.jointInformation.bottomRightCorner<2, 2>() -= prior.information / variance;
  fit.tiltPull = prior.information * (trial.tilt - prior.mean) / variance;
  return fit;
}

}  // namespace kelpie::gps
