// SPDX-License-Identifier: Apache-2.0
#include "gps/ball/BallFilter.h"

#include <algorithm>
#include <cmath>

#include "gps/Refusal.h"
#include "gps/ball/BallModels.h"
#include "robot/body/Camera.h"
#include "robot/body/FieldDescription.h"

namespace kelpie::gps {
namespace {

constexpr double kImageMargin = 12.0;      // px; a ball cut by the image border may be missed
constexpr double kCandidateReach = 15.0;   // cm between two sightings of a new ball, and
constexpr double kCandidateShare = 0.1;    // of its distance more
constexpr double kCandidateTime = 0.35;    // s between them
constexpr double kStillWeight = 0.5;       // of a new ball: lying or rolling
constexpr double kHeldStillWeight = 0.9;   // of a held ball
constexpr double kPlainGate = 2.0;         // standard deviations, of a sighting as expected
constexpr double kMinGatingWeight = 0.1;   // of a model that one sighting alone may confirm
constexpr double kMinKickedWeight = 1e-3;  // the same when we have kicked
constexpr double kCutSd = 4.0;             // cm, of a ball that the image border cuts
// Where no ball can be: the trunk and what is between the paws, in the robot frame.
constexpr double kBodyFront = 5.5;
constexpr double kBodyBack = -18.0;
constexpr double kBodyHalfWidth = 8.0;

bool usable(const BallPercept& p) {
  return std::isfinite(p.distance) && p.distance > 0.0 && p.distance < 1500.0 &&
         std::isfinite(p.heading.rad()) && std::isfinite(p.distanceVariance) &&
         p.distanceVariance > 0.0 && std::isfinite(p.headingVariance) && p.headingVariance > 0.0;
}

bool cut(const BallPercept& p) {
  return p.centre.x < p.radius || p.centre.x > kImageWidth - p.radius || p.centre.y < p.radius ||
         p.centre.y > kImageHeight - p.radius;
}

// Errors of a sighting, as standard deviations: along the sight and across it.
struct SightingSd {
  double along = 0.0;   // of the distance
  double across = 0.0;  // rad
};

SightingSd errorOf(const BallPercept& p, double headSpeed, const BallFilterParams& params) {
  const double reported = maths::square(1.0 / p.distance) * p.distanceVariance;
  const double share =
      maths::clamp(reported, maths::square(params.minShare), maths::square(params.maxShare)) +
      maths::square(params.sharePerHeadSpeed * headSpeed);
  const double heading = p.headingVariance + maths::square(params.headingSd.rad()) +
                         maths::square(params.headingLate * headSpeed);
  return {std::sqrt(share), std::sqrt(heading)};
}

BallSighting sighting(const BallPercept& p, double headSpeed, const BallFilterParams& params) {
  const Point2<Robot> at = robotPolar(p.distance, p.heading);
  const Vector2 along(at.x / p.distance, at.y / p.distance);
  const Vector2 across(-along(1), along(0));
  const double min = cut(p) ? kCutSd : params.minSd;
  const SightingSd sd = errorOf(p, headSpeed, params);
  const double radial = maths::square(std::max(sd.along * p.distance, min));
  const double sideways = maths::square(std::max(sd.across * p.distance, min));
  return {Vector2(at.x, at.y),
          radial * along * along.transpose() + sideways * across * across.transpose()};
}

void seenNow(BallTrack& ball) {
  ball.candidatePresent = false;
  ball.secondsSinceSeen = ball.weightedUnseenSeconds = 0.0;
  ball.missed = 0;
}

// A kick or a bounce explains it: the ball is where a new velocity would have taken it.
bool jumps(const BallSighting& z, double elapsed, const BallFilterParams& params, BallTrack& ball) {
  BallTrack other = ball;
  jumpModels(elapsed, params, other);
  if (!correctModels(z, params.gate, kMinGatingWeight, other)) return false;
  ball = other;
  return true;
}

// A lying ball seldom begins to roll, and a rolling one seldom bounces: one sighting that says so
// is as likely a false one, and taking it back needs another. After an own kick it is expected.
bool fits(const BallSighting& z, double elapsed, const BallFilterParams& params, BallTrack& ball) {
  if (ball.secondsSinceKick > params.kickSeconds)
    return correctModels(z, params.gate, kMinGatingWeight, ball);
  return correctModels(z, params.gate, kMinKickedWeight, ball) || jumps(z, elapsed, params, ball);
}

// The second sighting after a jump.
bool confirmsJump(const BallSighting& z, const BallFilterParams& params, BallState& state) {
  if (!state.jumped.present || !correctModels(z, params.gate, kMinGatingWeight, state.jumped))
    return false;
  state.track = state.jumped;
  return true;
}

// A sighting that fits nothing known: the second one near the first begins a track. One alone may
// be a shoe beyond the carpet.
bool begins(const BallSighting& z, double speedSd, BallTrack& ball) {
  const double apart =
      maths::hypot(z.position(0) - ball.candidate[0], z.position(1) - ball.candidate[1]);
  const double reach = kCandidateReach + kCandidateShare * z.position.norm();
  if (ball.candidatePresent && ball.candidateAge < kCandidateTime && apart < reach) {
    beginModels(z, speedSd, kStillWeight, ball);
    return true;
  }
  ball.candidatePresent = true;
  ball.candidateAge = 0.0;
  ball.candidate = {z.position(0), z.position(1)};
  return false;
}

// A sighting that hardly fits, or does not, may be the first after a jump.
void supposeJump(const BallSighting& z, double elapsed, const BallFilterParams& params,
                 const BallTrack& before, BallTrack& jumped) {
  jumped = before;
  if (correctModels(z, kPlainGate, kMinGatingWeight, jumped)) {
    jumped.present = false;
    return;
  }
  jumped.present = jumps(z, elapsed, params, jumped);
  jumped.candidateAge = 0.0;
}

void see(const BallIn& in, const BallFilterParams& params, BallState& state, GpsCounts& counts) {
  const BallSighting z = sighting(in.percept, body::headSpeed(in.input.headRate), params);
  const double elapsed = elapsedOf(in.input);
  BallTrack& ball = state.track;
  const BallTrack before = ball;
  const bool fitting = ball.present && fits(z, elapsed, params, ball);
  const double speedSd = ball.present ? params.kickSpeedSd : params.startSpeedSd;
  const bool begun = !fitting && (confirmsJump(z, params, state) || begins(z, speedSd, ball));
  if (fitting || begun) seenNow(ball);
  state.jumped.present = false;
  if (begun || !before.present) return;
  if (!fitting) count(Refusal::ballOutsideGate, counts);
  supposeJump(z, elapsed, params, before, state.jumped);
}

bool shouldBeSeen(const FrameInput& input, const BallTrack& ball, const BallFilterParams& params) {
  const std::array<double, 4>& mean = ball.both.mean;
  if (maths::hypot(mean[0], mean[1]) > params.missedReach) return false;
  const CameraPose camera = body::cameraPose(input.sensors.joints, input.stance);
  const auto pixel = body::project(camera, {mean[0], mean[1], body::kBallRadius});
  return pixel && pixel->x > kImageMargin && pixel->x < kImageWidth - kImageMargin &&
         pixel->y > kImageMargin && pixel->y < kImageHeight - kImageMargin;
}

void miss(const FrameInput& input, const BallFilterParams& params, BallTrack& ball) {
  ball.missed = shouldBeSeen(input, ball, params) ? ball.missed + 1 : 0;
  const double pace = ball.missed > params.missedFrames ? params.missedFactor : 1.0;
  ball.weightedUnseenSeconds += pace * elapsedOf(input);
  widenModels(pace * params.unseenNoise * elapsedOf(input), ball);
  if (ball.weightedUnseenSeconds > params.keep) ball.present = false;
}

void expectKick(const FrameInput& input, const BallFilterParams& params, BallTrack& ball) {
  const bool kicking = isKick(input.motion.running);
  const double away = maths::hypot(ball.both.mean[0], ball.both.mean[1]);
  if (!kicking || away > params.kickReach) return;
  ball.secondsSinceKick = 0.0;
  const double variance = maths::square(params.kickSpeedSd);
  for (const std::size_t diagonal : {std::size_t{10}, std::size_t{15}}) {
    ball.rolling.covariance[diagonal] = std::max(ball.rolling.covariance[diagonal], variance);
  }
  ball.rolling.weight = std::max(ball.rolling.weight, ball.still.weight);
  combineModels(ball);
}

// A ball that the body feels between chin, chest and forelegs is where those hold it, however the
// robot moves. Without this the track stayed on the carpet while the robot turned with the ball,
// and 10 cm beside it the search began after the kick.
void hold(const BallFilterParams& params, BallState& state) {
  const Vector2 at(0.0, params.heldAhead);
  const double variance = maths::square(params.heldSd);
  beginModels({at, variance * Matrix2::Identity()}, params.stopSpeed, kHeldStillWeight,
              state.track);
  seenNow(state.track);
  state.jumped.present = false;
}

// A track that has run into the body is put before it, at rest.
void keepOutOfBody(BallTrack& ball) {
  for (BallHypothesis* model : {&ball.still, &ball.rolling}) {
    std::array<double, 4>& mean = model->mean;
    const bool inside =
        std::fabs(mean[0]) < kBodyHalfWidth && mean[1] < kBodyFront && mean[1] > kBodyBack;
    if (inside) mean = {mean[0], kBodyFront, 0.0, 0.0};
  }
  combineModels(ball);
}

// After a jump of the clock the velocity may be of nothing and carries the ball away in one step.
void checkSound(BallTrack& ball, GpsCounts& counts) {
  constexpr double kMaxDistance = 1500.0;  // cm, twice the field's diagonal
  const bool near = maths::hypot(ball.both.mean[0], ball.both.mean[1]) <= kMaxDistance;
  if (near && meanOf(ball.both).allFinite() && covarianceOf(ball.both).allFinite()) return;
  ball = BallTrack{};
  count(Refusal::ballNotFinite, counts);
}

}  // namespace

void stepBall(const BallIn& in, const BallFilterParams& params, BallState& state,
              GpsCounts& counts) {
  BallTrack& ball = state.track;
  const double elapsed = elapsedOf(in.input);
  if (ball.present) expectKick(in.input, params, ball);
  for (BallTrack* one : {&ball, &state.jumped}) {
    one->secondsSinceSeen += elapsed;
    one->candidateAge += elapsed;
    one->secondsSinceKick += elapsed;
    if (!one->present) continue;
    predictModels(in.moved.odometry, in.moved.noise, elapsed, params, *one);
    keepOutOfBody(*one);
  }
  const bool good = in.percept.present && usable(in.percept);
  if (in.percept.present && !good) count(Refusal::ballNotFinite, counts);
  if (in.input.motion.feeling.ballHeld) {
    hold(params, state);
  } else if (good) {
    see(in, params, state, counts);
  } else if (ball.present) {
    miss(in.input, params, ball);
  }
  if (state.jumped.candidateAge > kCandidateTime) state.jumped.present = false;
  checkSound(ball, counts);
}

}  // namespace kelpie::gps
