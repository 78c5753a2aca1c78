// SPDX-License-Identifier: Apache-2.0
// When a robot rests and plays again: for its power, for want of images; and that the loops do it.
#include <gtest/gtest.h>

#include "robot/agent/AgentLoops.h"
#include "robot/agent/RestCommand.h"

namespace kelpie::agent {
namespace {

TimeUs at(double seconds) { return TimeUs::fromSeconds(seconds); }

struct Watched {
  Rest step(double seconds, const PowerReport& report) {
    return agent::step({at(seconds), report}, params, state);
  }
  PowerWatchParams params;
  PowerWatchState state;
};

PowerReport paused() {
  PowerReport report;
  report.paused = true;
  return report;
}
PowerReport low() {
  PowerReport report;
  report.batteryLow = true;
  return report;
}
TEST(PowerWatch, PausesAtOnceAndPlaysASecondAfterThePause) {
  Watched watched;
  EXPECT_EQ(watched.step(1.0, {}), Rest::none);
  EXPECT_EQ(watched.step(1.1, paused()), Rest::paused);
  EXPECT_EQ(watched.step(9.0, paused()), Rest::paused);
  EXPECT_EQ(watched.step(9.9, {}), Rest::paused);
  EXPECT_EQ(watched.step(10.1, {}), Rest::none);
}

TEST(PowerWatch, ABatteryThatRecoversWhileTheRobotLiesDoesNotRaiseItAtOnce) {
  Watched watched;
  watched.step(1.0, low());
  EXPECT_EQ(watched.step(20.0, {}), Rest::batteryLow);
  EXPECT_EQ(watched.step(31.5, {}), Rest::none);
}

TEST(PowerWatch, ThePauseIsToldBeforeWhatItBringsWithIt) {
  Watched watched;
  watched.step(0.0, {});
  PowerReport all;
  all.paused = all.batteryLow = all.hot = true;
  EXPECT_EQ(watched.step(1.0, all), Rest::paused);
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
  }
  std::vector<MotionInput> motions;
  Command lastCommand;
};

class RestingLoops : public testing::Test {
 protected:
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

TEST_F(RestingLoops, RestWhilePausedAndTellTheNextFrame) {
  play(60, true);
  loops_->power(paused());
  play(1, true);
  EXPECT_EQ(rest(), Rest::paused);
  EXPECT_EQ(sink_.lastCommand.leds, sink_.motions.back().command.leds);
  loops_->power({});
  play(33, true);
  EXPECT_EQ(rest(), Rest::none);
}

}  // namespace
}  // namespace kelpie::agent
