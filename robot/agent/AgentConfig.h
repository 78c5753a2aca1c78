// SPDX-License-Identifier: Apache-2.0
// Everything that is set before the first frame: who plays, every stage's parameters, the colour
// and ring table. Logged whole as /config, so that a log replays without any other file but the
// scripts.
#pragma once

#include "actuator/ActuatorParams.h"
#include "behaviour/BehaviourParams.h"
#include "gps/GpsParams.h"
#include "robot/agent/CameraSettings.h"
#include "robot/body/Camera.h"
#include "robot/body/FieldDescription.h"
#include "robot/core/types/FrameInput.h"
#include "robot/net/GameListener.h"
#include "vision/VisionParams.h"
#include "vision/colour/VisionCalibration.h"

namespace kelpie::agent {

struct AgentConfig {
  TeamColour team = TeamColour::red;
  std::uint8_t player = 1;
  // The one field that every stage reads, with the rules; agent::shareField() gives it to them.
  body::FieldDescription field = *body::fieldDescription("2006");
  body::BodyParams body;
  vision::VisionParams vision;
  gps::GpsParams gps;
  behaviour::BehaviourParams behaviour;
  actuator::ActuatorParams actuator;
  net::ListenerParams game;
  CameraSettings camera;
  vision::VisionCalibration calibration;

  template <int = 0>
  static constexpr auto fields() {
    using kelpie::field;
    return fieldList(
        field("team", &AgentConfig::team, "", 0, 1),
        field("player", &AgentConfig::player, "", 1, 4), field("field", &AgentConfig::field),
        field("body", &AgentConfig::body), field("vision", &AgentConfig::vision),
        field("gps", &AgentConfig::gps), field("behaviour", &AgentConfig::behaviour),
        field("actuator", &AgentConfig::actuator), field("game", &AgentConfig::game),
        field("camera", &AgentConfig::camera), field("calibration", &AgentConfig::calibration));
  }
};

// To be called when `field` has changed, before a stage is run.
inline void shareField(AgentConfig& config) {
  config.vision.field = config.field;
  config.gps.field = config.field;
}

}  // namespace kelpie::agent
