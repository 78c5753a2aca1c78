// SPDX-License-Identifier: Apache-2.0
// When a robot rests and plays again: for its power, for want of images; and that the loops do it.
#include <gtest/gtest.h>

#include "robot/agent/loops/AgentLoops.h"
#include "robot/agent/loops/RestCommand.h"

namespace kelpie::agent {
namespace {

TimeUs at(double seconds) { return TimeUs::fromSeconds(seconds); }

struct Watched {
  Cause step(double seconds, const CausesIn& in) {
    CausesIn now = in;
    now.time = at(seconds);
    return agent::step(now, params, state);
  }
  CausesParams params;
  CausesState state;
};

CausesIn paused() {
  CausesIn in;
  in.report.paused = true;
  return in;
}
CausesIn low() {
  CausesIn in;
  in.report.batteryLow = true;
  return in;
}
CausesIn hot() {
  CausesIn in;
  in.report.hot = true;
  return in;
}

TEST(Causes, PausesAtOnceAndPlaysASecondAfterThePause) {
  Watched watched;
  EXPECT_EQ(watched.step(1.0, {}).rest, Rest::none);
  EXPECT_EQ(watched.step(1.1, paused()).rest, Rest::paused);
  EXPECT_EQ(watched.step(3.0, paused()).demand, Demand::lie);
  EXPECT_EQ(watched.step(3.9, {}).rest, Rest::paused);
  EXPECT_EQ(watched.step(4.1, {}).rest, Rest::none);
}

TEST(Causes, APauseSwitchesOffAfterThreeSecondsInOnePiece) {
  Watched watched;
  for (int i = 0; i < 100; ++i) {
    const Cause cause = watched.step(0.1 * i, i % 10 < 9 ? paused() : CausesIn{});
    EXPECT_EQ(cause.demand, Demand::lie) << i;
  }
  EXPECT_EQ(watched.step(20.0, paused()).demand, Demand::lie);
  EXPECT_EQ(watched.step(22.9, paused()).demand, Demand::lie);
  EXPECT_EQ(watched.step(23.0, paused()).demand, Demand::switchOff);
}

TEST(Causes, ABatteryThatRecoversWhileTheRobotLiesDoesNotRaiseItAtOnce) {
  Watched watched;
  watched.step(1.0, low());
  EXPECT_EQ(watched.step(20.0, {}).rest, Rest::batteryLow);
  EXPECT_EQ(watched.step(31.5, {}).rest, Rest::none);
}

TEST(Causes, OneThatEndsDoesNotEndAnother) {
  Watched watched;
  watched.step(1.0, hot());
  watched.step(1.1, paused());
  watched.step(1.3, {});
  EXPECT_EQ(watched.step(20.0, {}).rest, Rest::hot);
}

TEST(Causes, TheGravestIsReported) {
  CausesIn all;
  all.stuck = all.blind = all.report.paused = all.report.fanFault = all.report.hot = true;
  all.report.overCurrent = all.report.batteryLow = true;
  const CausesParams params;
  const auto gravest = [&] {
    CausesState state;
    return step(all, params, state).rest;
  };
  EXPECT_EQ(gravest(), Rest::batteryLow);
  all.report.batteryLow = false;
  EXPECT_EQ(gravest(), Rest::overCurrent);
  all.report.overCurrent = false;
  EXPECT_EQ(gravest(), Rest::hot);
  all.report.hot = false;
  EXPECT_EQ(gravest(), Rest::fan);
  all.report.fanFault = false;
  EXPECT_EQ(gravest(), Rest::jointStuck);
  all.stuck = false;
  EXPECT_EQ(gravest(), Rest::paused);
  all.report.paused = false;
  EXPECT_EQ(gravest(), Rest::blind);
}

TEST(Watchdog, BarksAfterASecondWithoutAnImageAndNotBefore) {
  WatchdogState state;
  const WatchdogParams params;
  EXPECT_FALSE(step({at(5.0), false}, params, state)) << "the first step counts as an image";
  EXPECT_FALSE(step({at(5.99), false}, params, state));
  EXPECT_TRUE(step({at(6.0), false}, params, state));
  EXPECT_TRUE(step({at(7.0), false}, params, state));
  EXPECT_FALSE(step({at(7.03), true}, params, state));
  EXPECT_FALSE(step({at(8.0), false}, params, state));
}

TEST(RestCommand, AsksNothingOfTheBodyAndShowsWhy) {
  Command asked;
  asked.walk.forward = 30.0;
  asked.motion = MotionKind::kickForward;
  asked.leds = ~0U;
  asked.pinks = PinkUse::map;
  const Command command = restCommand(asked, {}, Rest::blind);
  EXPECT_EQ(command.walk.forward, 0.0);
  EXPECT_EQ(command.motion, MotionKind::none);
  EXPECT_EQ(command.leds, body::lights(GameState{}, Rest::blind));
  EXPECT_EQ(command.pinks, PinkUse::map) << "what it thinks goes on";
}

// Keeps what the loops tell the log.
class Sink : public LogSink {
 public:
  void motion(const MotionInput& input, const MotionOutput&) override { motions.push_back(input); }
  void frame(const FrameInput& input, const FrameOutput&) override {
    lastCommand = input.lastCommand;
    battery = input.battery;
  }
  std::vector<MotionInput> motions;
  Command lastCommand;
  Battery battery;
};

class RestingLoops : public testing::Test {
 protected:
  RestingLoops() { loops_->power(powered()); }
  static PowerReport powered() {
    PowerReport report;
    report.motorPower = true;
    return report;
  }
  // Messages of 32 ms, with an image each if wanted.
  void play(int messages, bool images) {
    for (int i = 0; i < messages; ++i) {
      MotionInput motion;
      motion.time = {32000 * ++sent_};
      const bool pressed = sent_ >= 3 && sent_ < 12;  // somebody asks it to stand
      for (SensorFrame& frame : motion.sensors) frame.headTouch = pressed ? 40.0 : 0.0;
      loops_->motion(motion);
      if (images) loops_->camera(*image_, motion.time, static_cast<std::uint32_t>(sent_));
    }
  }
  Rest rest() const { return sink_.motions.back().rest; }
  // A message with that of the battery, and an image.
  Battery told(double current, double charge) {
    MotionInput motion;
    motion.time = {32000 * ++sent_};
    motion.batteryCurrent = current;
    motion.batteryCharge = charge;
    loops_->motion(motion);
    loops_->camera(*image_, motion.time, static_cast<std::uint32_t>(sent_));
    return sink_.battery;
  }

  std::int64_t sent_ = 0;
  Sink sink_;
  std::unique_ptr<AgentConfig> config_ = std::make_unique<AgentConfig>();
  std::unique_ptr<Image> image_ = std::make_unique<Image>();
  std::unique_ptr<AgentLoops> loops_ =
      std::make_unique<AgentLoops>(*config_, KELPIE_SOURCE_DIR "/pycode", sink_);
};

TEST_F(RestingLoops, RestWhileTheCameraIsSilentAndNoLonger) {
  play(60, true);
  EXPECT_EQ(rest(), Rest::none);
  play(31, false);
  EXPECT_EQ(rest(), Rest::none);
  play(2, false);
  EXPECT_EQ(rest(), Rest::blind);
  EXPECT_NE(sink_.motions.back().command.leds & body::lightsOf(Rest::blind), 0U);
  play(2, true);
  EXPECT_EQ(rest(), Rest::none);
}

TEST_F(RestingLoops, TellTheNextFrameOfTheBattery) {
  const Battery battery = told(1850.0, 0.42);
  EXPECT_EQ(battery.current, 1850.0);
  EXPECT_EQ(battery.charge, 0.42);
  EXPECT_EQ(told(900.0, 0.41).current, 900.0);
}

TEST_F(RestingLoops, RestWhilePausedAndTellTheNextFrame) {
  play(60, true);
  PowerReport pausing = powered();
  pausing.paused = true;
  loops_->power(pausing);
  play(1, true);
  EXPECT_EQ(rest(), Rest::paused);
  EXPECT_EQ(sink_.lastCommand.leds, sink_.motions.back().command.leds);
  loops_->power(powered());
  play(33, true);
  EXPECT_EQ(rest(), Rest::none);
}

}  // namespace
}  // namespace kelpie::agent
