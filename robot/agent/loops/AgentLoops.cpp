// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/loops/AgentLoops.h"

#include "gps/camera/Focal.h"
#include "gps/camera/Lag.h"
#include "gps/camera/Tilt.h"
#include "robot/agent/loops/RestCommand.h"
#include "robot/net/TeamPacket.h"

namespace kelpie::agent {
namespace {

// More than this between two images is no gap: the camera began to count again.
constexpr std::uint32_t kMaxDropped = 900;  // 30 s

std::uint32_t droppedBetween(std::uint32_t last, std::uint32_t now) {
  const std::uint32_t step = now - last;  // modulo 2^32, as the counter runs over
  return step > 0 && step <= kMaxDropped ? step - 1 : 0;
}

// What was asked of the body. Why it was asked stays in the FrameOutput, or a log would tell it
// three times.
Command askedIn(const FrameOutput* frame) {
  if (frame == nullptr) return {};
  Command command = frame->command;
  command.trace.clear();
  return command;
}

}  // namespace

AgentLoops::AgentLoops(const AgentConfig& config, const std::string& scripts, LogSink& log,
                       const AgentLoops* beside)
    : frameLoop_(config, scripts, beside != nullptr ? &beside->frameLoop_ : nullptr),
      motionLoop_(config),
      log_(log),
      startingTilt_(gps::startingTilt(config.gps.tilt)),
      startingFocal_(gps::startingFocal(config.gps.focal)),
      startingLag_(gps::startingLag(config.gps.lag)),
      cameraSettings_(config.camera),
      listens_(config.game),
      game_(net::listenerFor(config.team, config.player)) {}

Cause AgentLoops::causeNow(const MotionInput& in) {
  const bool blind = step(WatchdogInput{in.time, imageCame_}, WatchdogParams{}, watchdog_);
  const bool stuck = step(in, JointWatchParams{}, jointWatch_).has_value();
  imageCame_ = false;
  return step(CausesIn{in.time, power_, stuck, blind}, CausesParams{}, causes_);
}

// A person who announces a match, by radio or by a button, or who drives, has asked for play.
void AgentLoops::decideMotors(const MotionInput& in) {
  MotorsIn motors;
  motors.time = in.time;
  motors.report = power_;
  motors.cause = causeNow(in);
  motors.held = in.held;
  motors.asked = game_.heard || game_.game.state != PlayState::initial || drive_.present;
  motors.pressed = in.sensors.back().headTouch >= listens_.buttons.headThreshold;
  if (motionOutput_ != nullptr) {
    motors.lying = motionOutput_->status.lying;
    motors.lifted = motionOutput_->status.feeling.lifted;
  }
  motors_ = step(motors, MotorsParams{}, motorsState_);
}

Command AgentLoops::forTheBody() const {
  const Command asked = askedIn(frame_);
  return motors_.rest == Rest::none ? asked : restCommand(asked, game_.game, motors_.reported);
}

const MotionOutput& AgentLoops::motion(const MotionInput& withoutCommand) {
  motionInput_.time = withoutCommand.time;
  motionInput_.sensors = withoutCommand.sensors;
  motionInput_.batteryCurrent = withoutCommand.batteryCurrent;
  motionInput_.batteryCharge = withoutCommand.batteryCharge;
  motionInput_.held = withoutCommand.held;
  decideMotors(motionInput_);
  motionInput_.rest = motors_.rest;
  motionInput_.command = forTheBody();
  motionOutput_ = &motionLoop_.step(motionInput_, silent_);
  commanded(motionOutput_->joints.back().target, jointWatch_);
  for (std::size_t tick = 0; tick < motionInput_.sensors.size(); ++tick) {
    const auto back = static_cast<std::int64_t>(motionInput_.sensors.size() - 1 - tick) * kTickUs;
    const TimeUs then{motionInput_.time.us - back};
    joints_.add(then, motionInput_.sensors[tick], motionOutput_->stances[tick]);
    feelButtons(then, motionInput_.sensors[tick]);
  }
  odometry_.add(motionInput_.time, motionOutput_->odometry);
  log_.motion(motionInput_, *motionOutput_);
  return *motionOutput_;
}

// A press that asked for the motors' power tells nothing of the game.
void AgentLoops::feelButtons(TimeUs when, const SensorFrame& sensed) {
  net::ButtonIn felt{when, sensed};
  if (motors_.tookPress) felt.sensors.headTouch = 0.0;
  net::feel(felt, listens_, game_);
}

void AgentLoops::expose(TimeUs exposureMiddle, std::uint32_t number) {
  input_.elapsed = frameCount_ == 0 ? 0.0 : (exposureMiddle - input_.time).seconds();
  if (frameCount_ > 0) input_.droppedFrames += droppedBetween(cameraNumber_, number);
  cameraNumber_ = number;
  input_.frame = frameCount_++;
  input_.time = exposureMiddle;
  input_.imageLag = frame_ != nullptr ? frame_->world.imageLag : startingLag_;
  const TimeUs exposed{exposureMiddle.us - TimeUs::fromSeconds(input_.imageLag.seconds).us};
  input_.sensors = joints_.at(exposed);
  input_.headRate = joints_.headRate(exposed);
  input_.stance = joints_.stance(exposed);
  input_.cameraTilt = frame_ != nullptr ? frame_->world.cameraTilt : startingTilt_;
  input_.focalScale = frame_ != nullptr ? frame_->world.focalScale : startingFocal_;
  input_.light = frame_ != nullptr ? frame_->percepts.light : CameraLight{};
  input_.odometry = odometry_.until(exposed);
  input_.motion = motionOutput_->status;
  input_.battery = {motionInput_.batteryCurrent, motionInput_.batteryCharge};
  input_.game = game_.game;
  input_.lastCommand = forTheBody();
  input_.drive = drive_;
  input_.radio = radio_.counts;
  input_.control = game_.counts;
}

void AgentLoops::take(const FrameOutput& frame) {
  frame_ = &frame;
  log_.frame(input_, frame);
  input_.team.clear();
}

void AgentLoops::camera(const Image& image, TimeUs exposureMiddle, std::uint32_t number) {
  imageCame_ = true;
  if (motionOutput_ == nullptr) return;  // no joints known yet: the image cannot be used
  expose(exposureMiddle, number);
  input_.image = image;
  take(frameLoop_.step(input_, silent_));
}

void AgentLoops::look(Sight& sight, TimeUs exposureMiddle, std::uint32_t number) {
  imageCame_ = true;
  if (motionOutput_ == nullptr) return;
  expose(exposureMiddle, number);
  take(frameLoop_.stepThrough(sight, input_, silent_));
}

void AgentLoops::hear(const ControlPacket& packet, TimeUs now) {
  net::hear(packet, now, listens_, game_);
}

void AgentLoops::hear(const RadioPacket& packet, TimeUs now) {
  net::hear(packet, now, game_.game.team, game_.game.player, radio_, input_.team);
}

bool AgentLoops::takePacket(RadioPacket& packet) {
  if (frame_ == nullptr) return false;
  const TeamMessage& message = frame_->world.message;
  if (message.number == 0 || message.number == sent_) return false;
  sent_ = message.number;
  return net::encode({game_.game.team, input_.time, message}, packet);
}

}  // namespace kelpie::agent
