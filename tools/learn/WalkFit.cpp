// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/WalkFit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "actuator/WalkSpeed.h"
#include "robot/core/Random.h"

namespace kelpie::learn {
namespace {

using actuator::Velocity;
using actuator::WalkCalibration;

constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;
constexpr int kStart = 36;     // messages until the speed is even
constexpr int kMeasured = 75;  // 2.4 s

// Half of the speeds go in one direction alone, the others in all at once.
Velocity drawn(const actuator::StrokeLimits& most, int number, Random& random) {
  const double share = random.uniform(0.2, 1.0);
  const int way = number % 8;
  if (way == 0) return {share * most.forward, 0.0, 0.0};
  if (way == 1) return {-share * most.back, 0.0, 0.0};
  if (way == 2) return {0.0, random.chance(0.5) ? share * most.left : -share * most.left, 0.0};
  if (way == 3) return {0.0, 0.0, random.chance(0.5) ? share * most.turn : -share * most.turn};
  std::array<double, 3> part{};
  for (double& p : part) p = random.gaussian(0.0, 1.0);
  const double size = std::sqrt(part[0] * part[0] + part[1] * part[1] + part[2] * part[2]);
  const double forward = part[0] < 0.0 ? most.back : most.forward;
  return {share * forward * part[0] / size, share * most.left * part[1] / size,
          share * most.turn * part[2] / size};
}

double square(double s) { return s * std::fabs(s); }

// The way of an even walk bends: forward and left are those along the arc.
Velocity evenSpeed(const Walked& walked, double seconds) {
  return {walked.forward / seconds, walked.left / seconds, walked.turn / seconds};
}

// Odometry that tells what the joints say and nothing else.
actuator::WalkOdometry jointsAlone() {
  WalkCalibration nothing;
  nothing.forward = nothing.back = nothing.left = nothing.turn = {0.0, 0.0};
  return {nothing, 1.0, 1.0, 1.0};
}

struct Rows {
  std::vector<std::vector<double>> features;
  std::vector<double> values;

  void add(const std::vector<double>& row, double value) {
    features.push_back(row);
    values.push_back(value);
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

// With joints their shares are fitted along with the curves.
actuator::WalkOdometry fitted(const std::vector<SpeedSample>& samples, bool withJoints) {
  Rows forward;
  Rows left;
  Rows turn;
  for (const auto& [feet, real, joints, load] : samples) {
    const double ahead = std::fmax(feet.forward, 0.0);
    const double behind = std::fmin(feet.forward, 0.0);
    const double use = withJoints ? 1.0 : 0.0;
    forward.add({ahead, square(ahead), behind, square(behind), std::fabs(feet.turn),
                 std::fabs(feet.left), feet.left * feet.turn, use * joints.forward},
                real.forward);
    left.add({feet.left, square(feet.left), feet.turn, square(feet.turn), feet.forward * feet.turn,
              use * joints.left},
             real.left);
    turn.add({feet.turn, square(feet.turn), feet.left, square(feet.left), feet.forward * feet.left,
              use * joints.turn},
             real.turn);
  }
  const Eigen::VectorXd f = forward.solved();
  const Eigen::VectorXd l = left.solved();
  const Eigen::VectorXd t = turn.solved();
  WalkCalibration c;
  c.forward = {f(0), f(1)};
  c.back = {f(2), f(3)};
  c.forwardPerTurn = f(4);
  c.forwardPerLeft = f(5);
  c.forwardPerLeftTurn = f(6);
  c.left = {l(0), l(1)};
  c.leftPerTurn = {l(2), l(3)};
  c.leftPerForwardTurn = l(4);
  c.turn = {t(0), t(1)};
  c.turnPerLeft = {t(2), t(3)};
  c.turnPerForwardLeft = t(4);
  return {c, f(7), l(5), t(5)};
}

}  // namespace

std::vector<SpeedSample> sampleSpeeds(WalkKind kind, const actuator::WalkSet& set,
                                      const sim::PhysicsParams& model, int count,
                                      std::uint64_t seed) {
  actuator::ActuatorParams params;
  actuator::WalkSet exact = set;
  exact.calibration = {};
  exact.odometry = jointsAlone();
  exact.freeLoad = {};
  actuator::walkSet(params.walks, kind) = exact;
  Random random(seed);
  std::vector<SpeedSample> samples;
  PhysicalWalker walker(model, params, seed);
  if (kind == WalkKind::weak) spare(walker);
  for (int i = 0; i < count; ++i) {
    const Velocity feet = drawn(set.most, i, random);
    Command command;
    command.walk = {feet.forward, feet.left, feet.turn, 0.0, kind};
    for (int m = 0; m < kStart; ++m) walker.step(command);
    Walked sum;
    Walked joints;
    double load = 0.0;
    for (int m = 0; m < kMeasured; ++m) {
      sum += walkOn(walker, command);
      const Odometry& told = walker.output().odometry;
      joints += {told.forward, told.left, told.turn.rad()};
      load += walker.output().status.feeling.load / kMeasured;
    }
    if (walker.fallen()) {
      walker = PhysicalWalker(model, params, seed);
      continue;
    }
    const double seconds = kMeasured * kMessageSeconds;
    samples.push_back({feet, evenSpeed(sum, seconds), evenSpeed(joints, seconds), load});
  }
  return samples;
}

WalkCalibration fitCalibration(const std::vector<SpeedSample>& samples) {
  return fitted(samples, false).commanded;
}

actuator::WalkOdometry fitOdometry(const std::vector<SpeedSample>& samples) {
  return fitted(samples, true);
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

}  // namespace kelpie::learn
