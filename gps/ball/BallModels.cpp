// SPDX-License-Identifier: Apache-2.0
#include "gps/ball/BallModels.h"

#include <algorithm>

#include "gps/ball/BallMotion.h"

namespace kelpie::gps {
namespace {

constexpr double kMinWeight = 1e-6;  // neither model dies permanently
constexpr double kJumpWeight = 0.9;  // of rolling, after a jump

struct Fit {
  Vector2 innovation;
  Matrix2 inverse;       // of its covariance
  double squared = 0.0;  // Mahalanobis distance
  double likelihood = 0.0;
};

Fit fitOf(const BallHypothesis& ball, const BallSighting& z) {
  Fit fit;
  const Matrix2 spread = covarianceOf(ball).topLeftCorner<2, 2>() + z.covariance;
  fit.innovation = z.position - meanOf(ball).head<2>();
  fit.inverse = spread.inverse();
  fit.squared = fit.innovation.dot(fit.inverse * fit.innovation);
  fit.likelihood = maths::exp(-0.5 * fit.squared) / std::sqrt(std::max(spread.determinant(), 1e-9));
  return fit;
}

void correct(const BallSighting& z, const Fit& fit, BallHypothesis& ball) {
  const BallMatrix p = covarianceOf(ball);
  const Eigen::Matrix<double, 4, 2> gain = p.leftCols<2>() * fit.inverse;
  BallMatrix keep = BallMatrix::Identity();
  keep.leftCols<2>() -= gain;
  set(ball, meanOf(ball) + gain * fit.innovation,
      keep * p * keep.transpose() + gain * z.covariance * gain.transpose());
}

// One Gaussian with the mean and the covariance of both; weights are summed.
BallHypothesis merged(const BallHypothesis& a, const BallHypothesis& b) {
  BallHypothesis all;
  all.weight = a.weight + b.weight;
  const double share = all.weight > 0.0 ? a.weight / all.weight : 0.5;
  const BallVector apart = meanOf(a) - meanOf(b);
  set(all, share * meanOf(a) + (1.0 - share) * meanOf(b),
      share * covarianceOf(a) + (1.0 - share) * covarianceOf(b) +
          share * (1.0 - share) * apart * apart.transpose());
  return all;
}

BallHypothesis lying(const BallHypothesis& ball, double weight) {
  BallVector mean = BallVector::Zero();
  BallMatrix covariance = BallMatrix::Zero();
  mean.head<2>() = meanOf(ball).head<2>();
  covariance.topLeftCorner<2, 2>() = covarianceOf(ball).topLeftCorner<2, 2>();
  BallHypothesis still;
  still.weight = weight;
  set(still, mean, covariance);
  return still;
}

BallHypothesis setRolling(const BallHypothesis& ball, double weight, double speedSd) {
  BallHypothesis rolling = lying(ball, weight);
  rolling.covariance[10] = rolling.covariance[15] = maths::square(speedSd);
  return rolling;
}

// The mixing step: a lying ball begins to roll, a slow one lies.
void changeModels(double elapsed, const BallFilterParams& params, BallTrack& ball) {
  const double starts = std::min(0.5, params.startRate * elapsed);
  const double speed = maths::hypot(ball.rolling.mean[2], ball.rolling.mean[3]);
  const double stops = speed < params.stopSpeed ? std::min(0.5, params.stopRate * elapsed) : 0.0;
  BallHypothesis still = ball.still;
  BallHypothesis rolling = ball.rolling;
  still.weight *= 1.0 - starts;
  rolling.weight *= 1.0 - stops;
  const BallHypothesis started =
      setRolling(ball.still, ball.still.weight * starts, params.startSpeedSd);
  const BallHypothesis stopped = lying(ball.rolling, ball.rolling.weight * stops);
  ball.still = merged(still, stopped);
  ball.rolling = merged(rolling, started);
}

void normalise(BallTrack& ball) {
  ball.still.weight = std::max(ball.still.weight, kMinWeight);
  ball.rolling.weight = std::max(ball.rolling.weight, kMinWeight);
  const double sum = ball.still.weight + ball.rolling.weight;
  ball.still.weight /= sum;
  ball.rolling.weight /= sum;
}

}  // namespace

void beginModels(const BallSighting& z, double speedSd, double stillWeight, BallTrack& ball) {
  placeModels(z, ball);
  ball.rolling = setRolling(ball.still, 1.0 - stillWeight, speedSd);
  ball.still.weight = stillWeight;
  ball.present = true;
  combineModels(ball);
}

void predictModels(const Odometry& odometry, const StepNoise& noise, double elapsed,
                   const BallFilterParams& params, BallTrack& ball) {
  changeModels(elapsed, params, ball);
  const double wander = params.velocityNoise * elapsed;
  for (BallHypothesis* model : {&ball.still, &ball.rolling}) {
    moveRobot(*model, odometry, noise);
    roll(*model, elapsed, params);
  }
  ball.rolling.covariance[10] += wander;
  ball.rolling.covariance[15] += wander;
  combineModels(ball);
}

// The last step is taken back, and taken again with an unknown velocity, so that the next sighting
// tells the velocity as well as the place.
void jumpModels(double elapsed, const BallFilterParams& params, BallTrack& ball) {
  const std::array<double, 4> mean = ball.both.mean;
  ball.rolling = setRolling(ball.both, kJumpWeight, params.kickSpeedSd);
  ball.still.weight = 1.0 - kJumpWeight;
  BallMatrix step = BallMatrix::Identity();
  step(0, 2) = step(1, 3) = elapsed;
  BallVector before = meanOf(ball.rolling);
  before.head<2>() -= elapsed * Vector2(mean[2], mean[3]);
  set(ball.rolling, before, step * covarianceOf(ball.rolling) * step.transpose());
  combineModels(ball);
}

bool correctModels(const BallSighting& z, double gate, double minWeight, BallTrack& ball) {
  const Fit still = fitOf(ball.still, z);
  const Fit rolling = fitOf(ball.rolling, z);
  const bool stillFits = ball.still.weight > minWeight && still.squared <= gate * gate;
  const bool rollingFits = ball.rolling.weight > minWeight && rolling.squared <= gate * gate;
  if (!stillFits && !rollingFits) return false;
  correct(z, still, ball.still);
  correct(z, rolling, ball.rolling);
  ball.still.weight *= still.likelihood;
  ball.rolling.weight *= rolling.likelihood;
  const double sum = ball.still.weight + ball.rolling.weight;
  if (sum > 0.0) {
    ball.still.weight /= sum;
    ball.rolling.weight /= sum;
  }
  combineModels(ball);
  return true;
}

void widenModels(double variance, BallTrack& ball) {
  for (BallHypothesis* model : {&ball.still, &ball.rolling}) {
    model->covariance[0] += variance;
    model->covariance[5] += variance;
  }
  combineModels(ball);
}

void placeModels(const BallSighting& z, BallTrack& ball) {
  BallVector mean = BallVector::Zero();
  BallMatrix covariance = BallMatrix::Zero();
  mean.head<2>() = z.position;
  covariance.topLeftCorner<2, 2>() = z.covariance;
  ball.still.weight = 1.0;
  set(ball.still, mean, covariance);
  ball.rolling = ball.still;
  ball.rolling.weight = 0.0;
  combineModels(ball);
}

void combineModels(BallTrack& ball) {
  normalise(ball);
  ball.both = merged(ball.still, ball.rolling);
}

}  // namespace kelpie::gps
