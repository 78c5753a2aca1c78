// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/Stuck.h"

#include <algorithm>

#include "gps/Refusal.h"

namespace kelpie::gps {
namespace {

constexpr double kStepSeconds = 0.35;  // 44 ticks, over which the effort is a mean

bool walks(const FrameInput& input) {
  const WalkRequest& walk = input.lastCommand.walk;
  const bool requested = walk.forward != 0.0 || walk.left != 0.0 || walk.turn != 0.0;
  return requested && input.motion.running == MotionKind::none;
}

// How fast the feet move, in cm/s of walking forward that costs as much effort.
double speedOfFeet(const FrameInput& input, const StuckParams& params) {
  if (!(elapsedOf(input) > 0.0) || !plausible(input.odometry)) return 0.0;
  const double left = params.sidewaysFactor * input.odometry.left;
  const double turn = params.turnLever * input.odometry.turn.rad();
  return maths::hypot(maths::hypot(input.odometry.forward, left), turn) / elapsedOf(input);
}

double excessLoad(const Feeling& feeling, const StuckParams& params) {
  const bool held = feeling.stuck && feeling.load <= 1.0;
  return held ? std::max(0.0, feeling.load - params.margin) : 0.0;
}

double factor(double excess, const StuckParams& params) {
  return 1.0 / (1.0 + params.slowing * excess);
}

}  // namespace

double freeEffort(double speed, const StuckParams& params) {
  return params.freeEffort + params.effortPerSpeed * speed;
}

double excessEffort(const FrameInput& input, const StuckParams& params, StuckState& state,
                    GpsCounts& counts) {
  const double now = speedOfFeet(input, params);
  state.speed += (now - state.speed) * std::min(1.0, elapsedOf(input) / kStepSeconds);
  const double effort = input.motion.effort;
  if (!(effort >= 0.0 && effort <= 1.0)) {
    count(Refusal::effortNotFinite, counts);
    return 0.0;
  }
  if (!params.use || !walks(input)) return 0.0;
  if (params.byLoad) return excessLoad(input.motion.feeling, params);
  // The effort is a mean over the last step, which may have been a faster one.
  const double speed = std::max(now, state.speed);
  return std::max(0.0, effort - freeEffort(speed, params) - params.margin);
}

Odometry shortened(const Odometry& odometry, double excess, const StuckParams& params) {
  if (excess <= 0.0) return odometry;
  const double share = factor(excess, params);
  return {share * odometry.forward, share * odometry.left, Angle::rad(share * odometry.turn.rad()),
          odometry.variance};
}

StepNoise grown(const StepNoise& noise, double excess, double elapsed, const StuckParams& params) {
  if (excess <= 0.0) return noise;
  const double share = 1.0 + params.growth * excess;
  const double pushed = params.pushed * excess * elapsed;
  return {share * noise.forward + pushed, share * noise.left + pushed,
          share * noise.turn + params.turned * excess * elapsed};
}

void stepStuck(double excess, double elapsed, const StuckParams& params, StuckState& state) {
  state.share = excess > 0.0 ? 1.0 - factor(excess, params) : 0.0;
  if (state.share > params.pauseAbove && params.pauseSeconds > 0.0) {
    state.paused = true;
    state.secondsPaused = 0.0;
    state.confirmed = 0;
    return;
  }
  state.secondsPaused += elapsed;
  if (state.secondsPaused >= params.pauseSeconds) state.paused = false;
}

void confirm(const StuckParams& params, StuckState& state) {
  if (!state.paused || state.share > params.pauseAbove) return;
  if (++state.confirmed >= params.pauseLandmarks) state.paused = false;
}

}  // namespace kelpie::gps
