// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/WalkFit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "actuator/WalkSpeed.h"
#include "robot/core/Random.h"
#include "tools/learn/HeldBall.h"

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
  return {nothing, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0};
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

Walked toldOf(const SwaySample& sample, const actuator::WalkOdometry& odometry) {
  const Velocity even = actuator::realSpeed(sample.stride.feet, odometry.commanded);
  return {sample.seconds * even.forward + odometry.joints * sample.joints.forward,
          sample.seconds * even.left + odometry.jointsLeft * sample.joints.left,
          sample.seconds * even.turn + odometry.jointsTurn * sample.joints.turn};
}

// The numbers of a curve as a row and back, in the order of its fields.
template <class S, class F>
void forEachNumber(S& curve, F f) {
  forEachField(curve, [&](const auto&, auto& member) {
    if constexpr (HasFields<std::decay_t<decltype(member)>>::value) {
      forEachNumber(member, f);
    } else {
      f(member);
    }
  });
}

std::vector<double> factors(const actuator::Stride& stride, const actuator::StrokeLimits& most,
                            actuator::SwaySide side) {
  std::vector<double> row;
  actuator::SwayCurve curve = actuator::swayFactors(stride, most, side);
  forEachNumber(curve, [&](double& number) { row.push_back(number); });
  return row;
}

actuator::SwayCurve curveOf(const Rows& rows) {
  const Eigen::VectorXd found = rows.solved();
  actuator::SwayCurve curve;
  Eigen::Index next = 0;
  forEachNumber(curve, [&](double& number) { number = found(next++); });
  return curve;
}

actuator::SwayCurve fitLean(const std::vector<SwaySample>& samples, double SwaySample::*quantity,
                            const actuator::StrokeLimits& most, actuator::SwaySide side) {
  Rows rows;
  for (const SwaySample& sample : samples)
    rows.add(factors(sample.stride, most, side), sample.*quantity);
  return curveOf(rows);
}

// What the odometry does not tell of a way between two instants is a difference of swings.
actuator::SwayCurve fitSwing(const std::vector<SwaySample>& samples, double Walked::*axis,
                             const actuator::WalkOdometry& odometry,
                             const actuator::StrokeLimits& most, actuator::SwaySide side) {
  Rows rows;
  for (const SwaySample& sample : samples) {
    std::vector<double> row = factors(sample.stride, most, side);
    const std::vector<double> before = factors(sample.before, most, side);
    for (std::size_t i = 0; i < row.size(); ++i) row[i] -= before[i];
    rows.add(row, sample.moved.*axis - toldOf(sample, odometry).*axis);
  }
  return curveOf(rows);
}

// With joints their shares are fitted along with the curves.
actuator::WalkOdometry fitted(const std::vector<SpeedSample>& samples, bool withJoints) {
  Rows forward;
  Rows left;
  Rows turn;
  for (const auto& [feet, real, joints, load] : samples) {
    const double ahead = std::fmax(feet.forward, 0.0);
    const double behind = std::fmin(feet.forward, 0.0);
    const double use = withJoints ? 1.0 : 0.0;
    forward.add(
        {ahead, square(ahead), behind, square(behind), std::fabs(feet.turn), std::fabs(feet.left),
         feet.left * feet.turn, use * joints.forward, use * load * feet.forward},
        real.forward);
    left.add({feet.left, square(feet.left), feet.turn, square(feet.turn), feet.forward * feet.turn,
              use * joints.left, use * load * feet.left},
             real.left);
    turn.add({feet.turn, square(feet.turn), feet.left, square(feet.left), feet.forward * feet.left,
              use * joints.turn, use * load * feet.turn},
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
  return {c, f(7), l(5), t(5), f(8), l(6), t(6)};
}

// Nothing of the set is fitted yet: the feet go as fast as they are told.
actuator::WalkSet unfitted(const actuator::WalkSet& set) {
  actuator::WalkSet exact = set;
  exact.calibration = {};
  exact.odometry = jointsAlone();
  exact.freeLoad = {};
  exact.sway = {};
  return exact;
}

SwaySample swayNow(const PhysicalWalker& walker) {
  const actuator::OdometryParams delay;
  const auto tick = actuator::shown(kTicksPerMessage - 1, delay, walker.state().odometry);
  const sim::BodyPlace place = walker.place();
  const Stance& legs = walker.output().stances.back();
  SwaySample sample;
  sample.stride = tick.stride;
  sample.tilt = (place.stance.bodyTilt - legs.bodyTilt).rad();
  sample.roll = place.lean.roll.rad();
  sample.height = place.stance.shoulderHeight - legs.shoulderHeight;
  return sample;
}

SpeedSample sampleSpeed(const Velocity& feet, const Command& command, PhysicalWalker& walker,
                        std::vector<SwaySample>& sways) {
  Walked sum;
  Walked joints;
  double load = 0.0;
  SwaySample last = swayNow(walker);
  for (int m = 0; m < kMeasured; ++m) {
    const Walked moved = walkOn(walker, command);
    const Odometry& odometry = walker.output().odometry;
    const Walked told{odometry.forward, odometry.left, odometry.turn.rad()};
    load += walker.output().status.feeling.load / kMeasured;
    SwaySample sample = swayNow(walker);
    sample.before = last.stride;
    sample.moved = moved;
    sample.joints = told;
    sample.seconds = kMessageSeconds;
    sum += moved;
    joints += told;
    sways.push_back(sample);
    last = sample;
  }
  const double seconds = kMeasured * kMessageSeconds;
  return {feet, evenSpeed(sum, seconds), evenSpeed(joints, seconds), load};
}

}  // namespace

void append(const WalkSamples& more, WalkSamples& all) {
  all.speeds.insert(all.speeds.end(), more.speeds.begin(), more.speeds.end());
  all.sways.insert(all.sways.end(), more.sways.begin(), more.sways.end());
}

WalkSamples sampleWalk(WalkKind kind, const actuator::WalkSet& set, const sim::PhysicsParams& model,
                       int count, std::uint64_t seed) {
  actuator::ActuatorParams params;
  actuator::walkSet(params.walks, kind) = unfitted(set);
  Random random(seed);
  WalkSamples samples;
  PhysicalWalker walker(model, params, seed);
  if (kind == WalkKind::weak) spare(walker);
  for (int i = 0; i < count; ++i) {
    const Velocity feet = drawn(set.most, i, random);
    Command command = kind == WalkKind::dribble ? holdingCommand() : Command{};
    if (kind == WalkKind::dribble && !holdsBall(walker)) giveBall({0.0, kHeldAhead}, walker);
    command.walk = {feet.forward, feet.left, feet.turn, 0.0, kind};
    for (int m = 0; m < kStart; ++m) walker.step(command);
    WalkSamples more;
    more.speeds.push_back(sampleSpeed(feet, command, walker, more.sways));
    if (walker.fallen()) {
      walker = PhysicalWalker(model, params, seed);
      continue;
    }
    append(more, samples);
  }
  return samples;
}

WalkCalibration fitCalibration(const std::vector<SpeedSample>& samples) {
  return fitted(samples, false).commanded;
}

actuator::WalkOdometry fitOdometry(const std::vector<SpeedSample>& samples,
                                   const actuator::FreeLoad& free) {
  std::vector<SpeedSample> felt = samples;
  for (SpeedSample& sample : felt) sample.load -= actuator::freeLoad(sample.feet, free);
  return fitted(felt, true);
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

actuator::WalkSway fitSway(const std::vector<SwaySample>& samples,
                           const actuator::WalkOdometry& odometry,
                           const actuator::StrokeLimits& most) {
  using actuator::SwaySide;
  return {fitLean(samples, &SwaySample::tilt, most, SwaySide::same),
          fitLean(samples, &SwaySample::roll, most, SwaySide::opposite),
          fitLean(samples, &SwaySample::height, most, SwaySide::same),
          fitSwing(samples, &Walked::forward, odometry, most, SwaySide::same),
          fitSwing(samples, &Walked::left, odometry, most, SwaySide::opposite),
          fitSwing(samples, &Walked::turn, odometry, most, SwaySide::opposite)};
}

}  // namespace kelpie::learn
