// SPDX-License-Identifier: Apache-2.0
#include "tools/teleop/Driver.h"

#include <algorithm>

#include "tools/learn/motion/BallInHold.h"

namespace kelpie::teleop {
namespace {

constexpr double kSpeedStep = 5.0;  // cm/s
constexpr int kMaxForward = 8;      // steps: 40 cm/s, what the walk can do
constexpr int kMaxBack = 6;
constexpr int kMaxLeft = 5;
constexpr double kTurnStep = 20.0;  // deg/s
constexpr int kMaxTurn = 8;
constexpr double kPanStep = 15.0;  // deg
constexpr int kMaxPan = 5;
constexpr double kTiltStep = 10.0;    // deg
constexpr double kFirstTilt = -20.0;  // deg below the horizon: a ball at 50 cm is in view
constexpr int kMaxUp = 5;
constexpr int kMaxDown = 4;
constexpr int kPatience = 90;  // views

MotionKind gettingUp(FallSide fallen) {
  switch (fallen) {
    case FallSide::front: return MotionKind::getUpFront;
    case FallSide::back: return MotionKind::getUpBack;
    case FallSide::left: return MotionKind::getUpLeft;
    case FallSide::right: return MotionKind::getUpRight;
    case FallSide::none: break;
  }
  return MotionKind::none;
}

// Motions after which no ball is held any more.
bool letsGo(MotionKind kind) {
  return isKick(kind) || kind == MotionKind::release || kind == MotionKind::stand || isGetUp(kind);
}

}  // namespace

void Driver::press(char key) {
  const KeyBinding* binding = bindingOf(key);
  if (binding != nullptr) take(*binding);
}

void Driver::stop() { forward_ = left_ = turn_ = 0; }

void Driver::take(const KeyBinding& binding) {
  forward_ = std::clamp(forward_ + binding.forward, -kMaxBack, kMaxForward);
  left_ = std::clamp(left_ + binding.left, -kMaxLeft, kMaxLeft);
  turn_ = std::clamp(turn_ + binding.turn, -kMaxTurn, kMaxTurn);
  pan_ = std::clamp(pan_ + binding.pan, -kMaxPan, kMaxPan);
  tilt_ = std::clamp(tilt_ + binding.tilt, -kMaxDown, kMaxUp);
  if (binding.motion != MotionKind::none) {
    motion_ = binding.motion;
    views_ = 0;
  }
  switch (binding.act) {
    case KeyAct::hold: holding_ = true; [[fallthrough]];  // the grab walks by itself
    case KeyAct::stop: stop(); break;
    case KeyAct::lookAhead: pan_ = tilt_ = 0; break;
    case KeyAct::mouth: mouthOpen_ = !mouthOpen_; break;
    case KeyAct::getUp: getUp_ = true; break;
    case KeyAct::quit: quit_ = true; break;
    case KeyAct::step:
    case KeyAct::motion: break;
  }
}

void Driver::follow(const MotionStatus& motion) {
  if (getUp_ && motion.feeling.fallen != FallSide::none) {
    stop();
    motion_ = gettingUp(motion.feeling.fallen);
    views_ = 0;
  }
  getUp_ = false;
  if (motion.running == motion_ || views_ >= kPatience) motion_ = MotionKind::none;
  if (letsGo(motion.running)) holding_ = false;
}

Command Driver::asked() const {
  Command command;
  if (holding_) {
    command = learn::holdingCommand();
  } else {
    command.head.aim = HeadAim::direction;
    command.head.direction = Angle::deg(kPanStep * pan_);
    command.head.elevation = Angle::deg(kFirstTilt + kTiltStep * tilt_);
    command.mouthOpen = mouthOpen_;
  }
  command.walk.forward = kSpeedStep * forward_;
  command.walk.left = kSpeedStep * left_;
  command.walk.turn = Angle::deg(kTurnStep * turn_).rad();
  return command;
}

Command Driver::next(const host::DriverView& view) {
  follow(view.motion);
  Command command = asked();
  // The actuator starts a motion when it is newly asked for and nothing else runs.
  if (motion_ != MotionKind::none && view.motion.running == MotionKind::none && view.motion.ready) {
    command.motion = motion_;
    ++views_;
  }
  return command;
}

}  // namespace kelpie::teleop
