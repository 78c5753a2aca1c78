// SPDX-License-Identifier: Apache-2.0
// A robot on a desk from switching on to switching off: what befalls it at which time, and what was
// called of power and gains, asked of the joints and shown to people.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot/agent/loops/AgentLoops.h"
#include "robot/body/Lights.h"
#include "robot/host/AgentStub.h"
#include "tools/desk/Stories.h"

namespace kelpie::agent {

using host::Desk;
using host::WatchedSystem;

constexpr double kGentle = 60.01;   // deg/s, of rounding
constexpr double kInFlight = 0.15;  // s, what was commanded before is still played

// The stand-in's system with what may go wrong in it.
class FaultySystem : public WatchedSystem {
 public:
  using WatchedSystem::WatchedSystem;

  OStatus observePower(const OPowerStatus& status, const OServiceEntry& entry) override {
    observer_ = entry;
    return WatchedSystem::observePower(status, entry);
  }
  // Power goes and comes back before the next message of the sensors.
  void dip() {
    OPowerStatus status;
    status.robotStatus = orsbBATTERY_CONNECTED;
    post(observer_, OPowerStatusMessage(status));
    status.robotStatus |= orsbMOTOR_POWER;
    post(observer_, OPowerStatusMessage(status));
  }
  OStatus setMotorPower(OPower power) override {
    if (!late || power != opowerON) return WatchedSystem::setMotorPower(power);
    note("power on");
    return oSUCCESS;
  }
  OStatus enableGain(OPrimitiveID id, bool enable) override {
    const auto primitive = find(id);
    if (enable && primitive && primitive->index == refused) return oFAIL;
    if (enable && !motorPower()) ++withoutPower;
    return WatchedSystem::enableGain(id, enable);
  }
  OStatus shutDown(const OBootCondition& condition) override {
    if (refusals == 0) return WatchedSystem::shutDown(condition);
    --refusals;
    return oFAIL;
  }

  bool late = false;                  // power that is asked for does not come
  std::size_t refused = kJointCount;  // a joint that takes no gain
  int refusals = 0;                   // of the end
  int withoutPower = 0;               // gains that came then

 private:
  OServiceEntry observer_;
};

class Story : public testing::Test, public LogSink {
 protected:
  Story() {
    desk_.frame.joints = desk::sprawled();
    params_.printTo = nullptr;
  }
  void motion(const MotionInput& input, const MotionOutput& output) override {
    if (rests.empty() || rests.back().rest != input.rest)
      rests.push_back({input.time.seconds(), input.rest});
    const bool plays = output.status.ready && input.rest == Rest::none;
    if (plays && readyAt == 0.0) readyAt = input.time.seconds();
    for (const JointFrame& frame : output.joints) {
      if (!plays && !played_) feelSpeed(input.held, frame.target);
      commanded_ = frame.target;
    }
    played_ = plays;
    leds = output.joints.back().leds;
    messages.push_back({input.time.seconds(), plays, input.held});
  }
  void frame(const FrameInput&, const FrameOutput&) override {}

  void at(double seconds, const std::function<void()>& happens) {
    events_.emplace(seconds, happens);
  }
  void press(double from, double seconds) {
    at(from, [this] { desk_.frame.headTouch = 40.0; });
    at(from + seconds, [this] { desk_.frame.headTouch = 0.0; });
  }
  void say(double from, longword bits) {
    at(from, [this, bits] { system_->setRobotStatus(orsbBATTERY_CONNECTED | bits); });
  }
  void play(double seconds) {
    AgentLoops loops(*config_, KELPIE_SOURCE_DIR "/pycode", *this);
    play(seconds, loops);
  }
  void play(double seconds, Loops& loops) {
    desk_.messages = static_cast<std::int32_t>(seconds / 0.032);
    Agent agent(loops);
    system_ = std::make_unique<FaultySystem>(desk_, params_);
    system_->broken = broken_;
    if (befallen_) befallen_(*system_);
    host::Network network;
    network.tick = [this](TimeUs now) {
      while (!events_.empty() && events_.begin()->first <= now.seconds()) {
        events_.begin()->second();
        events_.erase(events_.begin());
      }
    };
    const auto summary = system_->run(host::agentStub(agent), network);
    ASSERT_TRUE(summary) << summary.error();
  }

  // When it was called first after `from`; -1: never.
  double called(const std::string& what, double from = 0.0) const {
    for (const auto& call : system_->calls)
      if (call.what == what && call.time.seconds() >= from) return call.time.seconds();
    return -1.0;
  }
  double restedFrom(Rest rest, double from = 0.0) const {
    for (const auto& row : rests)
      if (row.rest == rest && row.at >= from) return row.at;
    return -1.0;
  }
  // The order in which joints were held in that time.
  std::vector<std::size_t> heldInTurn(double from, double to) const {
    std::vector<std::size_t> order;
    for (const auto& call : system_->calls) {
      const double when = call.time.seconds();
      if (call.what.rfind("hold ", 0) != 0 || when < from || when > to) continue;
      order.push_back(std::stoul(call.what.substr(5)));
    }
    return order;
  }
  void expectGainsInTurn(double from, double to) const {
    const auto order = heldInTurn(from, to);
    ASSERT_EQ(order.size(), kJointCount);
    for (std::size_t j = 0; j < kJointCount; ++j) {
      EXPECT_EQ(order[j], j);
      EXPECT_EQ(heldAt(called("hold " + std::to_string(j), from)), 1U) << "in one message";
    }
  }

  // How many joints came to be held at that time, in one message.
  std::size_t heldAt(double when) const {
    return static_cast<std::size_t>(
        std::count_if(system_->calls.begin(), system_->calls.end(), [when](const auto& call) {
          return call.what.rfind("hold ", 0) == 0 && call.time.seconds() == when;
        }));
  }
  std::size_t calledOften(const std::string& what, double from, double to) const {
    return static_cast<std::size_t>(
        std::count_if(system_->calls.begin(), system_->calls.end(), [&](const auto& call) {
          return call.what == what && call.time.seconds() >= from && call.time.seconds() <= to;
        }));
  }
  // Of the face's lights, for people.
  bool shows(Rest rest) const { return (leds & kReasons) == body::lightsOf(rest); }

  struct Row {
    double at;
    Rest rest;
  };
  struct Message {
    double at;
    bool plays;
    std::uint32_t held;
  };
  static constexpr std::uint32_t kReasons = 0xFU << (body::kFirstFaceLight + 10U);
  std::vector<Row> rests;
  std::vector<Message> messages;
  std::uint32_t leds = 0;
  double readyAt = 0.0;
  double fastestHeld = 0.0;  // deg/s, of a joint with a gain while it does not play
  Desk desk_;
  host::HostParams params_;
  std::unique_ptr<AgentConfig> config_ = std::make_unique<AgentConfig>();
  std::unique_ptr<FaultySystem> system_;
  std::set<std::string> broken_;
  std::function<void(FaultySystem&)> befallen_;  // before it starts
  std::multimap<double, std::function<void()>> events_;

 private:
  void feelSpeed(std::uint32_t held, const JointAngles& target) {
    for (std::size_t j = 0; j < kJointCount; ++j) {
      const double way = std::fabs((target.angle[j] - commanded_.angle[j]).deg());
      if ((held >> j & 1U) != 0) fastestHeld = std::max(fastestHeld, way / kTickSeconds);
    }
  }
  JointAngles commanded_;
  bool played_ = false;  // in the last message
};

}  // namespace kelpie::agent
