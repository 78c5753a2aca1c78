// SPDX-License-Identifier: Apache-2.0
#include "gps/BallFilter.h"

#include <algorithm>
#include <cmath>

#include "gps/BallGaussian.h"
#include "gps/BallMotion.h"
#include "robot/body/Camera.h"

namespace kelpie::gps {
namespace {

constexpr double kImageMargin = 12.0;     // px; a ball cut by the image border may be missed
constexpr double kCandidateReach = 15.0;  // cm between two sightings of a new ball, and
constexpr double kCandidateShare = 0.1;   // of its distance more
constexpr double kCandidateTime = 0.35;   // s between them
constexpr double kCutSd = 4.0;            // cm, of a ball that the image border cuts
// Where no ball can be: the trunk and what is between the paws, in the robot frame.
constexpr double kBodyFront = 5.5;
constexpr double kBodyBack = -18.0;
constexpr double kBodyHalfWidth = 8.0;

struct Sighting {
  Vector2 position;
  Matrix2 covariance;
};

bool usable(const BallPercept& p) {
  return std::isfinite(p.distance) && p.distance > 0.0 && p.distance < 1500.0 &&
         std::isfinite(p.heading.rad()) && std::isfinite(p.distanceVariance) &&
         p.distanceVariance > 0.0 && std::isfinite(p.headingVariance) && p.headingVariance > 0.0;
}

bool cut(const BallPercept& p) {
  return p.centre.x < p.radius || p.centre.x > kImageWidth - p.radius || p.centre.y < p.radius ||
         p.centre.y > kImageHeight - p.radius;
}

Sighting sighting(const BallPercept& p, const BallParams& params) {
  const Point2<Robot> at = robotPolar(p.distance, p.heading);
  const Vector2 along(at.x / p.distance, at.y / p.distance);
  const Vector2 across(-along(1), along(0));
  const double least = maths::square(cut(p) ? kCutSd : params.minSd);
  const double radial = std::max(p.distanceVariance, least);
  const double sideways = std::max(maths::square(p.distance) * p.headingVariance, least);
  return {Vector2(at.x, at.y),
          radial * along * along.transpose() + sideways * across * across.transpose()};
}

void begin(BallTrack& ball, const Sighting& z, double speedSd) {
  BallVector mean = BallVector::Zero();
  mean.head<2>() = z.position;
  BallMatrix covariance = BallMatrix::Zero();
  covariance.topLeftCorner<2, 2>() = z.covariance;
  covariance(2, 2) = covariance(3, 3) = maths::square(speedSd);
  set(ball, mean, covariance);
  ball.present = true;
}

void seenNow(BallTrack& ball) {
  ball.candidatePresent = false;
  ball.secondsSinceSeen = ball.doubt = 0.0;
  ball.missed = 0;
}

// False when the sighting lies outside the gate; nothing is changed then.
bool correct(BallTrack& ball, const Sighting& z, double gate) {
  const BallVector mean = meanOf(ball);
  const BallMatrix p = covarianceOf(ball);
  const Matrix2 inverse = (p.topLeftCorner<2, 2>() + z.covariance).inverse();
  const Vector2 innovation = z.position - mean.head<2>();
  if (innovation.dot(inverse * innovation) > gate * gate) return false;
  const Eigen::Matrix<double, 4, 2> gain = p.leftCols<2>() * inverse;
  BallMatrix keep = BallMatrix::Identity();
  keep.leftCols<2>() -= gain;
  set(ball, mean + gain * innovation,
      keep * p * keep.transpose() + gain * z.covariance * gain.transpose());
  return true;
}

// A sighting that fits nothing known: the second one near the first begins a track. One alone may
// be a shoe beyond the carpet.
void consider(const Sighting& z, double speedSd, BallTrack& ball) {
  const double apart =
      maths::hypot(z.position(0) - ball.candidate[0], z.position(1) - ball.candidate[1]);
  const double reach = kCandidateReach + kCandidateShare * z.position.norm();
  if (ball.candidatePresent && ball.candidateAge < kCandidateTime && apart < reach) {
    begin(ball, z, speedSd);
    seenNow(ball);
    return;
  }
  ball.candidatePresent = true;
  ball.candidateAge = 0.0;
  ball.candidate = {z.position(0), z.position(1)};
}

void see(const BallPercept& percept, const BallParams& params, GpsState& state) {
  BallTrack& ball = state.ball;
  const Sighting z = sighting(percept, params);
  if (!ball.present) {
    consider(z, params.startSpeedSd, ball);
  } else if (correct(ball, z, params.gate)) {
    seenNow(ball);
  } else {
    state.count(Refusal::ballOutsideGate);
    consider(z, params.kickSpeedSd, ball);
  }
}

bool shouldBeSeen(const FrameInput& input, const BallTrack& ball, const BallParams& params) {
  if (maths::hypot(ball.mean[0], ball.mean[1]) > params.missedReach) return false;
  const CameraPose camera = body::cameraPose(input.sensors.joints, input.stance);
  const auto pixel = body::project(camera, {ball.mean[0], ball.mean[1], body::kBallRadius});
  return pixel && pixel->x > kImageMargin && pixel->x < kImageWidth - kImageMargin &&
         pixel->y > kImageMargin && pixel->y < kImageHeight - kImageMargin;
}

void miss(const FrameInput& input, const BallParams& params, BallTrack& ball) {
  ball.missed = shouldBeSeen(input, ball, params) ? ball.missed + 1 : 0;
  const double pace = ball.missed > params.missedFrames ? params.missedFactor : 1.0;
  ball.doubt += pace * input.elapsed;
  for (const std::size_t diagonal : {std::size_t{0}, std::size_t{5}}) {
    ball.covariance[diagonal] += pace * params.unseenNoise * input.elapsed;
  }
  if (ball.doubt > params.keep) ball.present = false;
}

void expectKick(const FrameInput& input, const BallParams& params, BallTrack& ball) {
  const bool kicking = input.motion.running == MotionKind::kickForward;
  if (!kicking || maths::hypot(ball.mean[0], ball.mean[1]) > params.kickReach) return;
  const double variance = maths::square(params.kickSpeedSd);
  for (const std::size_t diagonal : {std::size_t{10}, std::size_t{15}}) {
    ball.covariance[diagonal] = std::max(ball.covariance[diagonal], variance);
  }
}

// A track that has run into the body is put before it, at rest.
void keepOutOfBody(BallTrack& ball) {
  const bool inside = std::fabs(ball.mean[0]) < kBodyHalfWidth && ball.mean[1] < kBodyFront &&
                      ball.mean[1] > kBodyBack;
  if (!inside) return;
  ball.mean[1] = kBodyFront;
  ball.mean[2] = ball.mean[3] = 0.0;
}

void checkFinite(GpsState& state) {
  const BallTrack& ball = state.ball;
  if (meanOf(ball).allFinite() && covarianceOf(ball).allFinite()) return;
  state.ball = BallTrack{};
  state.count(Refusal::ballNotFinite);
}

}  // namespace

void stepBall(const FrameInput& input, const BallPercept& percept, const StepNoise& noise,
              const GpsParams& params, GpsState& state) {
  BallTrack& ball = state.ball;
  ball.secondsSinceSeen += input.elapsed;
  ball.candidateAge += input.elapsed;
  if (ball.present) {
    if (plausible(input.odometry)) moveRobot(ball, input.odometry, noise);
    expectKick(input, params.ball, ball);
    roll(ball, input.elapsed, params.ball);
    keepOutOfBody(ball);
  }
  const bool good = percept.present && usable(percept);
  if (percept.present && !good) state.count(Refusal::ballNotFinite);
  if (good) {
    see(percept, params.ball, state);
  } else if (ball.present) {
    miss(input, params.ball, ball);
  }
  checkFinite(state);
}

}  // namespace kelpie::gps
