// SPDX-License-Identifier: Apache-2.0
// A robot on a desk, for its start and end: joints that follow their targets where a
// motor holds them and stay where they are where none does, gravity, and somebody who presses,
// pauses and lifts at given times. What the agent calls of power and gains is kept in its order.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "robot/host/HostSystem.h"

namespace kelpie::host {

// Keeps the calls that make a motor strong or weak, as words: "power on", "limp", "gain 3 0.25".
class WatchedSystem : public HostSystem {
 public:
  using HostSystem::HostSystem;

  OStatus openPrimitive(const char* locator, OPrimitiveID* id) override {
    if (broken.count(locator) > 0) return oOPEN_FAILURE;
    return HostSystem::openPrimitive(locator, id);
  }
  OStatus setMotorPower(OPower power) override {
    note(power == opowerON ? "power on" : "power off");
    return HostSystem::setMotorPower(power);
  }
  OStatus enableGain(OPrimitiveID id, bool enable) override {
    const auto primitive = find(id);
    const std::string joint = primitive ? std::to_string(primitive->index) : "all";
    note((enable ? "hold " : "limp ") + joint);
    return HostSystem::enableGain(id, enable);
  }
  OStatus setGain(OPrimitiveID id, const openr::GainSettings& gain) override {
    note("gain " + std::to_string(find(id)->index) + " " + std::to_string(gain.p));
    return HostSystem::setGain(id, gain);
  }
  OStatus shutDown(const OBootCondition& condition) override {
    note(condition.bitmap == obcbPAUSE_SW ? "shut down" : "shut down for good");
    return RobotPrimitives::shutDown(condition);
  }
  // As a robot that cuts the power by itself, and gives it back.
  void jam() { HostSystem::setMotorPower(opowerOFF); }
  void giveBack() { HostSystem::setMotorPower(opowerON); }

  struct Call {
    TimeUs time;
    std::string what;
  };
  std::vector<Call> calls;
  std::set<std::string> broken;  // locators that do not open

 protected:
  void note(const std::string& what) {
    const SystemTime now = time();
    calls.push_back({{static_cast<std::int64_t>(now.seconds) * 1000000 + now.useconds}, what});
  }
};

// Messages of 32 ms with an image each.
class Desk : public Source {
 public:
  Expected<bool> next(WorldEvent& event) override {
    event.step = {};
    if (!imageNext_ && message_ == messages) return false;
    event.step.time = {imageNext_ ? 32000 * message_ + 9000 : 32000 * (message_ + 1)};
    if (imageNext_) {
      event.step.imagePresent = images && message_ % imageEvery == 0;
    } else {
      sense(event.step);
      ++message_;
    }
    imageNext_ = !imageNext_;
    return true;
  }

  Status reply(const AgentReply& reply) override {
    power = reply.motorPower;
    gains = reply.gains;
    for (const EffectorVector& vector : reply.vectors) vectors_.push_back(vector);
    if (!reply.vectors.empty()) leds = reply.vectors[reply.vectors.size() - 1].leds;
    return Done{};
  }

  std::int32_t messages = 0;
  bool images = true;
  std::int32_t imageEvery = 1;  // messages
  bool power = false;
  std::uint32_t gains = 0;
  bool lifted = false;        // a hand shakes it a little all the while
  bool pawsFail = false;      // their switches tell nothing
  std::uint32_t blocked = 0;  // bit i: joint i cannot move
  std::uint32_t leds = 0;     // of the last vector
  SensorFrame frame = standingOnDesk();
  // Raw targets as they were played, a tick each, and when.
  std::vector<std::pair<TimeUs, RawJoints>> played;

 private:
  static constexpr double kShake = 150.0;  // cm/s2

  static SensorFrame standingOnDesk() {
    SensorFrame frame;
    frame.acceleration = {0.0, 0.0, 981.0};
    frame.paw.fill(true);
    return frame;
  }

  void sense(WorldStep& step) {
    step.sensorsPresent = true;
    step.firstTick = static_cast<std::uint32_t>(4 * message_ + 1);
    if (!vectors_.empty()) play(step);
    frame.paw.fill(!lifted && !pawsFail);
    SensorFrame shaken = frame;
    if (lifted) shaken.acceleration[0] += message_ / 3 % 2 == 0 ? kShake : -kShake;
    step.sensors.fill(rawOf(shaken));
  }

  void play(WorldStep& step) {
    for (std::uint32_t tick = 0; tick < kTicksPerMessage; ++tick)
      played.emplace_back(step.time, vectors_.front().targets[tick]);
    const JointAngles target = anglesOf(played.back().second);
    for (std::size_t j = 0; j < kJointCount; ++j)
      if (power && (gains >> j & ~(blocked >> j) & 1U) != 0)
        frame.joints.angle[j] = target.angle[j];
    vectors_.erase(vectors_.begin());
    step.vectorsDone = 1;
  }

  std::int32_t message_ = 0;
  bool imageNext_ = false;
  std::vector<EffectorVector> vectors_;
};

// deg/s, of any joint between two ticks that were played before `end`.
inline double fastest(const Desk& desk, double begin, double end) {
  double max = 0.0;
  for (std::size_t i = 1; i < desk.played.size(); ++i) {
    const double at = desk.played[i].first.seconds();
    if (at < begin || at > end) continue;
    for (std::size_t j = 0; j < kJointCount; ++j) {
      const double way = desk.played[i].second.value[j] - desk.played[i - 1].second.value[j];
      max = std::max(max, std::fabs(way) * openr::kMicroradian / kTickSeconds);
    }
  }
  return max * 180.0 / maths::kPi;
}

}  // namespace kelpie::host
