// SPDX-License-Identifier: Apache-2.0
// Where a log holds why: once, in the FrameOutput; and such a log replays to the same bits.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "robot/agent/log/Replay.h"
#include "robot/agent/loops/AgentLoops.h"
#include "robot/core/log/LogWriter.h"

namespace kelpie::agent {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScript =
    "import kelpie\n\n\ndef decide(world):\n"
    "    why = (kelpie.LAYER_SKILL, 'go', 'ahead', 'frame {} at {} s', world.frame, world.time_s)\n"
    "    return kelpie.Command(walk=kelpie.WalkRequest(forward=10.0), trace=[why] * 3)\n";

// Writes a log as the agent does, and looks at what passes.
class Sink : public LogSink {
 public:
  Sink(const std::string& path, const AgentConfig& config)
      : log_(std::move(*LogWriter::open(path))) {
    log_.write(kConfigTopic, TimeUs{}, config);
  }
  void motion(const MotionInput& input, const MotionOutput& output) override {
    walked = walked || input.command.walk.forward > 0.0;
    repeated += input.command.trace.size();
    log_.write(kMotionInputTopic, input.time, input);
    log_.write(kMotionOutputTopic, input.time, output);
  }
  void frame(const FrameInput& input, const FrameOutput& output) override {
    repeated += input.lastCommand.trace.size();
    reported += output.command.trace.size();
    log_.write(kFrameInputTopic, input.time, input);
    log_.write(kFrameOutputTopic, input.time, output);
  }
  Status close() { return log_.close(); }

  bool walked = false;
  std::size_t reported = 0;
  std::size_t repeated = 0;

 private:
  LogWriter log_;
};

class TraceLog : public testing::Test {
 protected:
  TraceLog() {
    std::string pattern = (fs::temp_directory_path() / "kelpieXXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    std::ofstream(folder_ / "main.py") << kScript;
  }
  ~TraceLog() override { fs::remove_all(folder_); }

  void play(AgentLoops& loops, std::uint32_t frames) const {
    const auto image = std::make_unique<Image>();
    PowerReport power;
    power.motorPower = true;
    loops.power(power);
    for (std::uint32_t i = 0; i < frames; ++i) {
      const TimeUs now{static_cast<std::int64_t>(i + 1) * 32000};
      MotionInput motion;
      motion.time = now;
      const bool pressed = i >= 3 && i < 12;  // somebody asks it to stand
      for (SensorFrame& frame : motion.sensors) frame.headTouch = pressed ? 40.0 : 0.0;
      loops.motion(motion);
      loops.camera(*image, now, i);
    }
  }

  fs::path folder_;
};

TEST_F(TraceLog, WhyIsRecordedOnceAndReplaysBitForBit) {
  const std::string path = (folder_ / "log.mcap").string();
  const auto config = std::make_unique<AgentConfig>();
  {
    Sink sink(path, *config);
    const auto loops = std::make_unique<AgentLoops>(*config, folder_.string(), sink);
    play(*loops, 60);
    EXPECT_EQ(loops->scriptError(), "");
    EXPECT_TRUE(sink.walked);
    EXPECT_EQ(sink.reported, 180U);
    EXPECT_EQ(sink.repeated, 0U);
    ASSERT_TRUE(sink.close());
  }
  StageObserver silent;
  ReplayOptions options;
  options.scripts = folder_.string();
  std::string reason;
  options.onFrame = [&](const FrameInput&, const FrameOutput& output) {
    reason = output.command.trace[0].reason.view();
  };
  const auto result = replay(path, options, silent);
  ASSERT_TRUE(result) << result.error();
  EXPECT_EQ(result->frames, 60U);
  EXPECT_EQ(result->differing, 0U) << result->differences.front();
  EXPECT_EQ(reason, "frame {} at {} s");
}

}  // namespace
}  // namespace kelpie::agent
