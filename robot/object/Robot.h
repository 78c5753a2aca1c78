// SPDX-License-Identifier: Apache-2.0
// What the OPEN-R object of a robot is made of: the configuration, and the loops, which are made
// when the stick has been read and not by a static constructor: what goes wrong there can be
// reported to nobody (openr.md 5.1).
#pragma once

#include <memory>
#include <string>

#include "robot/agent/AgentConfig.h"
#include "robot/agent/loops/AgentLoops.h"
#include "robot/agent/loops/FaultLoops.h"

namespace kelpie::object {

// Everything as in the code: standard parameters, no calibration of one robot. 258 KB.
std::unique_ptr<agent::AgentConfig> makeConfig();

// The loops of a robot: on it nobody listens.
struct SilentSink {
  agent::LogSink silent;
};
class RobotLoops : private SilentSink, public agent::AgentLoops {
 public:
  RobotLoops(const agent::AgentConfig& config, const std::string& scripts)
      : AgentLoops(config, scripts, silent) {}
};

// Hands everything to the loops that play, for which there is room here: 0.7 MB, part of the object
// and not of the heap. Until make() it is the fault's loops that answer.
class LateLoops : public agent::Loops {
 public:
  LateLoops() = default;
  LateLoops(const LateLoops&) = delete;
  LateLoops& operator=(const LateLoops&) = delete;
  ~LateLoops() override;

  // Once; later calls do nothing, and so does refuse() from then on. `scripts`: the zip of the
  // behaviours; empty: those inside the program.
  void make(const agent::AgentConfig& config, const std::string& scripts);
  // Until then the robot shows these lights.
  void show(std::uint32_t leds) { fault_.show(leds); }
  // The robot does not play and shows this number.
  void refuse(std::uint8_t fault);

  const MotionOutput& motion(const MotionInput& input) override { return at_->motion(input); }
  const agent::MotorsOut& motors() const override { return at_->motors(); }
  void power(const agent::PowerReport& report) override {
    power_ = report;
    at_->power(report);
  }
  agent::CameraSettings cameraSettings() const override { return at_->cameraSettings(); }
  void camera(const Image& image, TimeUs exposed, std::uint32_t number) override {
    at_->camera(image, exposed, number);
  }
  void hear(const ControlPacket& packet, TimeUs now) override { at_->hear(packet, now); }
  void hear(const RadioPacket& packet, TimeUs now) override { at_->hear(packet, now); }
  bool takePacket(RadioPacket& packet) override { return at_->takePacket(packet); }
  const behaviour::ReportLine* takeLine() override { return at_->takeLine(); }

 private:
  union Storage {
    Storage() {}   // NOLINT(modernize-use-equals-default): the loops are made later
    ~Storage() {}  // NOLINT(modernize-use-equals-default): LateLoops ends them
    RobotLoops loops;
  };

  bool made() const { return at_ != &fault_; }

  Storage storage_;
  agent::FaultLoops fault_;
  agent::PowerReport power_;  // reported last; the loops that come later need it
  agent::Loops* at_ = &fault_;
};

}  // namespace kelpie::object
