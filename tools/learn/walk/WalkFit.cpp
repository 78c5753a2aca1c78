// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/walk/WalkFit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "actuator/odometry/OdometryTerms.h"
#include "tools/learn/Numbers.h"

namespace kelpie::learn {
namespace {

using actuator::Velocity;
using actuator::WalkCalibration;

double square(double s) { return s * std::fabs(s); }

struct Rows {
  std::vector<std::vector<double>> features;
  std::vector<double> values;

  void add(const std::vector<double>& row, double value) {
    features.push_back(row);
    values.push_back(value);
  }
  // Keeps the numbers from that column on small (ridge regression): each costs that share of the
  // squares of its column.
  void holdBack(std::size_t first, double share) {
    const std::size_t columns = features.front().size();
    std::vector<std::vector<double>> held;
    for (std::size_t k = first; k < columns; ++k) {
      double squares = 0.0;
      for (const std::vector<double>& row : features) squares += maths::square(row[k]);
      std::vector<double> row(columns, 0.0);
      row[k] = std::sqrt(share * squares);
      held.push_back(row);
    }
    features.insert(features.end(), held.begin(), held.end());
    values.resize(features.size(), 0.0);
  }
  Eigen::VectorXd solved() const {
    const auto rows = static_cast<Eigen::Index>(features.size());
    const auto columns = static_cast<Eigen::Index>(features.front().size());
    Eigen::MatrixXd a(rows, columns);
    Eigen::VectorXd b(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
      for (Eigen::Index k = 0; k < columns; ++k)
        a(i, k) = features[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
      b(i) = values[static_cast<std::size_t>(i)];
    }
    return a.colPivHouseholderQr().solve(b);
  }
};

std::vector<double> weighted(std::vector<double> row, double weight) {
  for (double& number : row) number *= weight;
  return row;
}

template <class S>
S solved(const Rows& rows) {
  const Eigen::VectorXd found = rows.solved();
  S values;
  Eigen::Index next = 0;
  forEachNumber(values, [&](double& number) { number = found(next++); });
  return values;
}

Walked reckonedOf(const OscillationSample& sample, const actuator::WalkOdometry& odometry) {
  const Velocity even = actuator::likelySpeed(sample.stride.feet, {}, odometry);
  return {sample.seconds * even.forward + odometry.forward.joints * sample.joints.forward,
          sample.seconds * even.left + odometry.left.joints * sample.joints.left,
          sample.seconds * even.turn + odometry.turn.joints * sample.joints.turn};
}

actuator::OscillationCurve fitLean(const std::vector<OscillationSample>& samples,
                                   double OscillationSample::*quantity,
                                   const actuator::StrokeLimits& max,
                                   actuator::OscillationSymmetry side) {
  Rows rows;
  for (const OscillationSample& sample : samples)
    rows.add(numbersOf(actuator::oscillationFactors(sample.stride, max, side)), sample.*quantity);
  return solved<actuator::OscillationCurve>(rows);
}

// What the odometry does not tell of a way between two instants is a difference of swings.
actuator::OscillationCurve fitSwing(const std::vector<OscillationSample>& samples,
                                    double Walked::*axis, const actuator::WalkOdometry& odometry,
                                    const actuator::StrokeLimits& max,
                                    actuator::OscillationSymmetry side) {
  Rows rows;
  for (const OscillationSample& sample : samples) {
    std::vector<double> row = numbersOf(actuator::oscillationFactors(sample.stride, max, side));
    const auto before = numbersOf(actuator::oscillationFactors(sample.before, max, side));
    for (std::size_t i = 0; i < row.size(); ++i) row[i] -= before[i];
    rows.add(row, sample.moved.*axis - reckonedOf(sample, odometry).*axis);
  }
  return solved<actuator::OscillationCurve>(rows);
}

}  // namespace

WalkCalibration fitCalibration(const std::vector<SpeedSample>& samples) {
  Rows forward;
  Rows left;
  Rows turn;
  for (const SpeedSample& sample : samples) {
    const auto& [ahead, lateral, round] = sample.feet;
    const double front = std::fmax(ahead, 0.0);
    const double behind = std::fmin(ahead, 0.0);
    forward.add({front, square(front), behind, square(behind), std::fabs(round), std::fabs(lateral),
                 lateral * round},
                sample.real.forward);
    left.add({lateral, square(lateral), round, square(round), ahead * round}, sample.real.left);
    turn.add({round, square(round), lateral, square(lateral), ahead * lateral}, sample.real.turn);
  }
  const Eigen::VectorXd f = forward.solved();
  const Eigen::VectorXd l = left.solved();
  const Eigen::VectorXd t = turn.solved();
  return {{f(0), f(1)}, {f(2), f(3)}, {l(0), l(1)}, {t(0), t(1)}, {l(2), l(3)}, {t(2), t(3)},
          f(4),         f(5),         f(6),         l(4),         t(4)};
}

actuator::WalkOdometry fitOdometry(const std::vector<PathSample>& samples) {
  Rows forward;
  Rows left;
  Rows turn;
  for (const PathSample& sample : samples) {
    forward.add(weighted(sample.forward, sample.weight), sample.weight * sample.real.forward);
    left.add(weighted(sample.left, sample.weight), sample.weight * sample.real.left);
    turn.add(weighted(sample.turn, sample.weight), sample.weight * sample.real.turn);
  }
  // Two dozen models differ in fewer ways than legs have joints: without it turns of models that
  // the fit had not seen were estimated 3.2 deg off, with it 2.9.
  constexpr double kHeld = 3e-4;
  const std::size_t side = numbersOf(actuator::SideReach{}).size();  // they come last
  forward.holdBack(numbersOf(actuator::AlongTerms{}).size() - 2 * side, kHeld);
  left.holdBack(numbersOf(actuator::AcrossTerms{}).size() - 4 * side, kHeld);
  turn.holdBack(numbersOf(actuator::AcrossTerms{}).size() - 4 * side, kHeld);
  return {solved<actuator::AlongTerms>(forward), solved<actuator::AcrossTerms>(left),
          solved<actuator::AcrossTerms>(turn)};
}

actuator::FreeLoad fitFreeLoad(const std::vector<SpeedSample>& samples) {
  Rows rows;
  for (const SpeedSample& sample : samples)
    rows.add({std::fmax(sample.feet.forward, 0.0), std::fmax(-sample.feet.forward, 0.0),
              std::fabs(sample.feet.left), std::fabs(sample.feet.turn)},
             sample.load);
  const Eigen::VectorXd free = rows.solved();
  return {free(0), free(1), free(2), free(3)};
}

actuator::WalkOscillation fitOscillation(const std::vector<OscillationSample>& samples,
                                         const actuator::WalkOdometry& odometry,
                                         const actuator::StrokeLimits& max) {
  using actuator::OscillationSymmetry;
  return {fitLean(samples, &OscillationSample::tilt, max, OscillationSymmetry::same),
          fitLean(samples, &OscillationSample::roll, max, OscillationSymmetry::opposite),
          fitLean(samples, &OscillationSample::height, max, OscillationSymmetry::same),
          fitSwing(samples, &Walked::forward, odometry, max, OscillationSymmetry::same),
          fitSwing(samples, &Walked::left, odometry, max, OscillationSymmetry::opposite),
          fitSwing(samples, &Walked::turn, odometry, max, OscillationSymmetry::opposite)};
}

}  // namespace kelpie::learn
