// SPDX-License-Identifier: Apache-2.0
// A source without a world, and loops without stages, for the tests of the dispatcher and the
// agent.
#pragma once

#include <vector>

#include "robot/agent/loops/Loops.h"
#include "robot/host/Source.h"

namespace kelpie::host {

// Plays steps from a list and keeps the replies. A vector is played for 32 ms, two at most wait.
class FakeSource : public Source {
 public:
  Expected<bool> next(WorldEvent& event) override {
    if (place_ == steps.size()) {
      if (!failure.empty()) return Error{failure};
      return false;
    }
    event.step = steps[place_++];
    event.image = image;
    return true;
  }
  Status reply(const AgentReply& reply) override {
    replies.push_back(reply);
    return Done{};
  }

  // Sensor messages at 32, 64, .. ms; from the second on one vector has been played.
  void addSensors(std::uint32_t messages) {
    for (std::uint32_t i = 0; i < messages; ++i) {
      WorldStep step;
      step.firstTick = 4 * sent_ + 1;
      step.time.us = 32000 * ++sent_;
      step.sensorsPresent = true;
      step.vectorsDone = sent_ > 1 ? 1 : 0;
      SensorFrame frame;
      frame.joints[Joint::headPan] = Angle::deg(10.0 + sent_);
      frame.joints[Joint::mouth] = Angle::deg(-20.0);
      step.sensors.fill(rawOf(frame));
      steps.push_back(step);
    }
  }
  void addImage(std::int64_t us) {
    WorldStep step;
    step.time.us = us;
    step.imagePresent = true;
    steps.push_back(step);
  }

  std::vector<WorldStep> steps;
  std::vector<AgentReply> replies;
  Image image;
  std::string failure;

 private:
  std::size_t place_ = 0;
  std::uint32_t sent_ = 0;
};

// Keeps what it is given and asks the head to pan by the number of the message, in degrees.
class FakeLoops : public agent::Loops {
 public:
  static agent::MotorsOut allOn() {
    agent::MotorsOut on;
    on.rest = on.reported = Rest::none;
    on.order.power = true;
    on.order.strength.fill(1.0);
    return on;
  }
  const MotionOutput& motion(const MotionInput& input) override {
    inputs.push_back(input);
    const Angle pan = Angle::deg(static_cast<double>(inputs.size()));
    for (JointFrame& frame : output.joints) {
      frame.target[Joint::headPan] = pan;
      frame.leds = leds;
    }
    return output;
  }
  const agent::MotorsOut& motors() const override { return ordered; }
  void power(const agent::PowerReport& report) override { reports.push_back(report); }
  void camera(const Image& image, TimeUs exposureMiddle, std::uint32_t number) override {
    lastImage = image;
    exposures.push_back(exposureMiddle);
    cameraNumbers.push_back(number);
  }
  void hear(const ControlPacket& packet, TimeUs) override { controls.push_back(packet); }
  void hear(const RadioPacket& packet, TimeUs) override { packets.push_back(packet); }
  const behaviour::ReportLine* takeLine() override { return nullptr; }
  bool takePacket(RadioPacket& packet) override {
    packet = says;
    says.bytes.clear();
    return packet.bytes.size() > 0;
  }

  std::vector<MotionInput> inputs;
  std::vector<agent::PowerReport> reports;
  std::vector<ControlPacket> controls;
  std::vector<RadioPacket> packets;
  RadioPacket says;  // once
  std::vector<TimeUs> exposures;
  std::vector<std::uint32_t> cameraNumbers;
  Image lastImage;
  MotionOutput output;
  agent::MotorsOut ordered = allOn();
  std::uint32_t leds = 0;
};

}  // namespace kelpie::host
