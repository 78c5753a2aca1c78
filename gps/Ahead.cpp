// SPDX-License-Identifier: Apache-2.0
#include "gps/Ahead.h"

#include "gps/pose/Predict.h"

namespace kelpie::gps {

namespace {

constexpr double kMostFrames = 5.0;  // that images lag

}  // namespace

Odometry sinceExposure(const FrameInput& input) {
  const double elapsed = elapsedOf(input);
  if (!(elapsed > 0.0) || !plausible(input.odometry)) return {};
  const double share = maths::clamp(input.imageLag.seconds / elapsed, 0.0, kMostFrames);
  return {
      share * input.odometry.forward, share * input.odometry.left, input.odometry.turn * share, {}};
}

void bringForward(const Odometry& step, WorldModel& world) {
  world.pose = moved(world.pose, step);
  for (PoseMode& mode : world.modes) mode.pose = moved(mode.pose, step);
  if (world.second.present) world.second.mode.pose = moved(world.second.mode.pose, step);
  BallEstimate& ball = world.ball;
  if (!ball.present) return;
  ball.relative = robotFromField(moved({}, step), fieldFromRobot({}, ball.relative));
  ball.distance = ball.relative.norm();
  ball.heading = bearing(ball.relative);
}

}  // namespace kelpie::gps
