// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/loops/FrameLoop.h"

#include "robot/body/Camera.h"
#include "robot/body/Lights.h"

namespace kelpie::agent {

FrameLoop::FrameLoop(const AgentConfig& config, const std::string& scripts, const FrameLoop* beside)
    : config_(config),
      vision_(config.calibration),
      behaviour_(scripts, config.behaviour.constants,
                 beside != nullptr ? &beside->behaviour_ : nullptr) {
  shareField(config_);
  gps::prepare(config_.gps, gps_);
}

void FrameLoop::sense(const FrameInput& input, StageObserver& observer) {
  output_.frame = input.frame;
  output_.time = input.time;
  observer.begin(Stage::body);
  output_.body = body::step(input, config_.body);
  observer.end(Stage::body);
}

void FrameLoop::decide(const FrameInput& input, StageObserver& observer) {
  observer.begin(Stage::gps);
  gps::stepInto(output_.world, {input, output_.percepts, output_.body.camera}, config_.gps, gps_);
  observer.end(Stage::gps);

  observer.begin(Stage::behaviour);
  output_.command = behaviour::step(
      {input, output_.percepts, output_.world, config_.field, config_.body.infrared},
      config_.behaviour, behaviour_);
  Command& command = output_.command;
  command.leds =
      body::lights(input.game, command.team.role, command.leds) | body::lightsOf(command.fallback);
  observer.end(Stage::behaviour);
}

const FrameOutput& FrameLoop::step(const FrameInput& input, StageObserver& observer) {
  sense(input, observer);
  observer.begin(Stage::vision);
  vision::stepInto(output_.percepts, {input, output_.body}, config_.vision, vision_);
  observer.end(Stage::vision);
  decide(input, observer);
  return output_;
}

const FrameOutput& FrameLoop::stepThrough(Sight& sight, const FrameInput& input,
                                          StageObserver& observer) {
  sense(input, observer);
  observer.begin(Stage::vision);
  sight.see(input, output_.body, output_.percepts);
  observer.end(Stage::vision);
  decide(input, observer);
  return output_;
}

const FrameOutput& FrameLoop::stepFrom(const Percepts& seen, const FrameInput& input,
                                       StageObserver& observer) {
  sense(input, observer);
  output_.percepts = seen;
  decide(input, observer);
  return output_;
}

}  // namespace kelpie::agent
