// SPDX-License-Identifier: Apache-2.0
#include "robot/object/SimplePlayer.h"

#include <cmath>

#include "robot/body/Lights.h"

namespace kelpie::object {
namespace {

// The gates and gains of pycode/lib/steer.py: within the first angle full speed, beyond the second
// a turn on the spot.
constexpr double kAheadWithin = 30.0;  // deg
constexpr double kOnTheSpot = 80.0;    // deg
constexpr double kSpeed = 34.0;        // cm/s
constexpr double kSlowDown = 1.2;      // 1/s: from 28 cm on the speed falls with the distance
constexpr double kTurnGain = 1.8;      // 1/s
constexpr double kTurnSpeed = 90.0;    // deg/s; at 100 and more images smear
constexpr double kBallTop = 8.4;       // cm
// A ball that rolled out of sight may be anywhere after this; a turn of the head takes half of it.
constexpr double kForget = 2.0;  // s
// Slow enough that a ball stays in the image, 57 deg wide, for 20 frames of a turn.
constexpr double kSearchSpeed = 60.0;  // deg/s
constexpr double kSearchPan = 40.0;    // deg, ahead of the turn
constexpr double kScanPan = 60.0;      // deg to both sides, as BehaviourParams::scanPan
constexpr double kScanPeriod = 3.0;    // s
constexpr double kScanTilt = -20.0;    // deg

MotionKind motionFor(FallSide side) {
  if (side == FallSide::front) return MotionKind::getUpFront;
  if (side == FallSide::back) return MotionKind::getUpBack;
  if (side == FallSide::left) return MotionKind::getUpLeft;
  if (side == FallSide::right) return MotionKind::getUpRight;
  return MotionKind::none;
}

bool getsUp(const MotionStatus& motion) {
  return motion.feeling.fallen != FallSide::none || isGetUp(motion.running);
}

void explain(Command& command, const char* branch, const char* reason) {
  TraceStep step;
  step.layer = TraceLayer::player;
  step.module.assign("simple");
  step.branch.assign(branch);
  step.reason.assign(reason);
  command.trace.push_back(step);
}

Command getUp(const MotionStatus& motion, SimpleState& state) {
  Command command;
  if (!state.askedToGetUp && motion.running == MotionKind::none)
    command.motion = motionFor(motion.feeling.fallen);
  state.askedToGetUp = command.motion != MotionKind::none;
  explain(command, "gets_up", "it has fallen");
  return command;
}

Command waits(TimeUs now) {
  Command command;
  command.head.neckTilt = Angle::deg(kScanTilt);
  command.head.headPan =
      Angle::deg(kScanPan * maths::sin(2.0 * maths::kPi * now.seconds() / kScanPeriod));
  explain(command, "waits", "play is halted");
  return command;
}

Command goesTo(const BallEstimate& ball) {
  Command command;
  const double off = ball.heading.deg();
  const double share =
      maths::clamp((kOnTheSpot - std::fabs(off)) / (kOnTheSpot - kAheadWithin), 0.0, 1.0);
  command.walk.forward = share * maths::clamp(kSlowDown * ball.distance, 0.0, kSpeed);
  command.walk.turn = Angle::deg(maths::clamp(kTurnGain * off, -kTurnSpeed, kTurnSpeed)).rad();
  command.head.aim = HeadAim::point;
  command.head.target = {ball.relative.x, ball.relative.y, kBallTop};
  explain(command, "goes_to_ball", "the ball is known");
  return command;
}

Command searches(bool left) {
  Command command;
  const double side = left ? 1.0 : -1.0;
  command.walk.turn = Angle::deg(side * kSearchSpeed).rad();
  command.head.neckTilt = Angle::deg(kScanTilt);
  command.head.headPan = Angle::deg(side * kSearchPan);
  explain(command, "searches", "the ball is lost");
  return command;
}

Command decide(const behaviour::BehaviourIn& in, SimpleState& state) {
  const GameState& game = in.input.game;
  if (game.state != PlayState::playing || game.penalised) return waits(in.input.time);
  if (getsUp(in.input.motion)) return getUp(in.input.motion, state);
  state.askedToGetUp = false;
  const BallEstimate& ball = in.world.ball;
  if (!ball.present || ball.secondsSinceSeen > kForget) return searches(state.searchesLeft);
  state.searchesLeft = ball.heading.rad() >= 0.0;
  return goesTo(ball);
}

}  // namespace

Command step(const behaviour::BehaviourIn& in, SimpleState& state) {
  Command command = decide(in, state);
  command.leds |= body::kLightBackMiddle;
  return command;
}

}  // namespace kelpie::object
