// SPDX-License-Identifier: Apache-2.0
// The loops of a robot that cannot play: its memory stick has not been read yet or was refused, or
// a vital part of it does not open. It stays as it lies, its motors have no power, and its lights
// tell how far it is, or blink the fault's number (body::faultLights). It sees, hears and says
// nothing, but a pause switch that is held and an empty battery switch it off as they do any robot.
#pragma once

#include "robot/agent/joints/Causes.h"
#include "robot/agent/loops/Loops.h"

namespace kelpie::agent {

class FaultLoops : public Loops {
 public:
  void setFault(std::uint8_t fault) { fault_ = fault; }
  void show(std::uint32_t leds) { shown_ = leds; }

  const MotionOutput& motion(const MotionInput& input) override;
  const MotorsOut& motors() const override { return motors_; }
  void power(const PowerReport& report) override { power_ = report; }
  void camera(const Image& /*image*/, TimeUs /*exposed*/, std::uint32_t /*number*/) override {}
  void hear(const ControlPacket& /*packet*/, TimeUs /*now*/) override {}
  void hear(const RadioPacket& /*packet*/, TimeUs /*now*/) override {}
  bool takePacket(RadioPacket& /*packet*/) override { return false; }
  const behaviour::ReportLine* takeLine() override { return nullptr; }

 private:
  std::uint8_t fault_ = 0;
  std::uint32_t shown_ = 0;
  PowerReport power_;
  CausesState causes_;
  MotorsOut motors_{Rest::none, Rest::none, {}, false};  // no power; the fault is reported already
  MotionOutput output_;
};

}  // namespace kelpie::agent
