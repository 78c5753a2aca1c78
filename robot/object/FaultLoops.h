// SPDX-License-Identifier: Apache-2.0
// The loops of a robot whose memory stick has not been read yet, or was refused: it stays as it
// lies, its motors have no power, and its lights tell how far it is, or blink the fault's number
// (body::faultLights). It sees, hears and says nothing.
#pragma once

#include "robot/agent/Loops.h"

namespace kelpie::object {

class FaultLoops : public agent::Loops {
 public:
  void setFault(std::uint8_t fault) { fault_ = fault; }
  void show(std::uint32_t leds) { shown_ = leds; }

  const MotionOutput& motion(const MotionInput& input) override;
  const agent::MotorsOut& motors() const override { return motors_; }
  void power(const agent::PowerReport& /*report*/) override {}
  void camera(const Image& /*image*/, TimeUs /*exposed*/, std::uint32_t /*number*/) override {}
  void hear(const ControlPacket& /*packet*/, TimeUs /*now*/) override {}
  void hear(const RadioPacket& /*packet*/, TimeUs /*now*/) override {}
  bool takePacket(RadioPacket& /*packet*/) override { return false; }
  const behaviour::ToldLine* takeLine() override { return nullptr; }

 private:
  std::uint8_t fault_ = 0;
  std::uint32_t shown_ = 0;
  agent::MotorsOut motors_{Rest::none, {}};  // no power, and the stick's fault is told already
  MotionOutput output_;
};

}  // namespace kelpie::object
