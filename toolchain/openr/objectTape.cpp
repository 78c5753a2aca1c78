// SPDX-License-Identifier: Apache-2.0
// object-tape LOG TAPE [FRAMES [PYCODE]]   writes what toolchain/emulate plays to the emulated
// image: the configuration, then each input of the log with the output that the stages make of it
// here, on the PC. Frames without their image end the tape. Beforehand every output is compared
// with what the log says was made of the input when it was recorded. Without PYCODE, the folder of
// the behaviours that played, no Commands are compared: so object-tape-simple is called, which has
// the simple player in place of Python. Exit code 0: written, 1: this PC makes something else than
// was recorded, 2: bad input.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robot/agent/log/FrameMessages.h"
#include "robot/agent/loops/FrameLoop.h"
#include "robot/agent/loops/MotionLoop.h"
#include "toolchain/openr/TapeWriter.h"

namespace {

using namespace kelpie;
using tape::TapeWriter;

constexpr std::uint32_t kStandardFrames = 300;

struct Counts {
  std::uint32_t frames = 0;
  std::uint32_t motionSteps = 0;
  std::uint32_t differing = 0;
};

class Tape {
 public:
  Tape(TapeWriter& out, std::uint32_t frames, std::string scripts)
      : out_(out), max_(frames), scripts_(std::move(scripts)) {}

  bool full() const { return imageless_ || (counts_.frames >= max_ && waitingFrame_ == nullptr); }
  const Counts& counts() const { return counts_; }

  Status take(const LogMessage& message) {
    const std::string& topic = message.topic();
    if (topic == kConfigTopic) return configure(message);
    if (!frames_) return Done{};
    if (topic == kFrameInputTopic) return frameIn(message);
    if (topic == kFrameOutputTopic) return frameOut(message);
    if (topic == kMotionInputTopic) return motionIn(message);
    if (topic == kMotionOutputTopic) return motionOut(message);
    imageless_ = agent::isFrameInput(topic);
    return Done{};
  }

 private:
  Status configure(const LogMessage& message) {
    const auto config = std::make_unique<agent::AgentConfig>();
    const Status read = decodeAs(message, *config);
    if (!read) return read;
    frames_ = std::make_unique<agent::FrameLoop>(*config, scripts_);
    motion_ = std::make_unique<agent::MotionLoop>(*config);
    out_.put('c', *config);
    return Done{};
  }
  Status frameIn(const LogMessage& message) {
    const Status read = decodeAs(message, frameInput_);
    if (!read) return read;
    waitingFrame_ = &frames_->step(frameInput_, silent_);
    out_.put('f', frameInput_, *waitingFrame_);
    ++counts_.frames;
    return Done{};
  }
  Status frameOut(const LogMessage& message) {
    const Status read = decodeAs(message, recordedFrame_);
    if (!read || waitingFrame_ == nullptr) return read;
    if (scripts_.empty()) recordedFrame_.command = waitingFrame_->command;  // another player
    compare(recordedFrame_, *waitingFrame_);
    waitingFrame_ = nullptr;
    return Done{};
  }
  Status motionIn(const LogMessage& message) {
    const Status read = decodeAs(message, motionInput_);
    if (!read) return read;
    waitingMotion_ = &motion_->step(motionInput_, silent_);
    out_.put('m', motionInput_, *waitingMotion_);
    ++counts_.motionSteps;
    return Done{};
  }
  Status motionOut(const LogMessage& message) {
    const Status read = decodeAs(message, recordedMotion_);
    if (!read || waitingMotion_ == nullptr) return read;
    compare(recordedMotion_, *waitingMotion_);
    waitingMotion_ = nullptr;
    return Done{};
  }
  template <class T>
  void compare(const T& recorded, const T& now) {
    std::string path;
    if (!firstDifference(recorded, now, &path)) return;
    ++counts_.differing;
    std::fprintf(stderr, "object-tape: frame %u: %s\n", frameInput_.frame, path.c_str());
  }

  TapeWriter& out_;
  std::uint32_t max_;
  std::string scripts_;     // of the player that was recorded; empty: another one decides
  bool imageless_ = false;  // came to a frame whose image was not kept
  Counts counts_;
  agent::StageObserver silent_;
  std::unique_ptr<agent::FrameLoop> frames_;
  std::unique_ptr<agent::MotionLoop> motion_;
  FrameInput frameInput_;
  MotionInput motionInput_;
  FrameOutput recordedFrame_;
  MotionOutput recordedMotion_;
  const FrameOutput* waitingFrame_ = nullptr;    // made, not yet compared
  const MotionOutput* waitingMotion_ = nullptr;  // so
};

int complain(const std::string& line) {
  std::fprintf(stderr, "object-tape: %s\n", line.c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3 || argc > 5) return complain("usage: object-tape LOG TAPE [FRAMES [PYCODE]]");
  const std::string log = argv[1];
  const long wanted = argc > 3 ? std::strtol(argv[3], nullptr, 10) : long{kStandardFrames};
  if (wanted < 1 || wanted > 100000) return complain("FRAMES is a number from 1 to 100000");
  auto reader = LogReader::open(log);
  if (!reader) return complain(reader.error());
  TapeWriter writer(argv[2]);
  const auto tape = std::make_unique<Tape>(writer, static_cast<std::uint32_t>(wanted),
                                           argc > 4 ? argv[4] : std::string());
  LogMessage message;
  while (!tape->full() && reader->next(message)) {
    const Status taken = tape->take(message);
    if (!taken) return complain(log + ": " + taken.error());
  }
  if (!reader->status()) return complain(reader->status().error());
  if (!writer.close()) return complain(std::string(argv[2]) + ": cannot be written");
  const Counts& counts = tape->counts();
  if (counts.frames == 0) return complain(log + ": holds no frames with their images");
  std::printf("%u frames, %u motion steps, %u differ from the recording\n", counts.frames,
              counts.motionSteps, counts.differing);
  return counts.differing == 0 ? 0 : 1;
}
