// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/log/Replay.h"

#include <algorithm>

#include "robot/agent/log/FrameMessages.h"

namespace kelpie::agent {
namespace {

constexpr std::size_t kShownDifferences = 5;

// One replay: the loops are made when the configuration has been read.
class Player {
 public:
  Player(const ReplayOptions& options, StageObserver& observer, ReplayResult& result)
      : options_(options), observer_(observer), result_(result) {}

  Status take(const LogMessage& message) {
    const std::string& topic = message.topic();
    if (topic == kConfigTopic) return configure(message);
    const bool ours = isFrameInput(topic) || topic == kFrameOutputTopic ||
                      topic == kMotionInputTopic || topic == kMotionOutputTopic;
    if (!ours) return Done{};
    if (!frameLoop_)
      return Error{topic + " comes before " + kConfigTopic + ": not a log of an agent"};
    if (isFrameInput(topic)) return frameIn(message);
    if (topic == kFrameOutputTopic) return frameOut(message);
    if (topic == kMotionInputTopic) return motionIn(message);
    return motionOut(message);
  }
  bool enough() const {
    return options_.maxFrames > 0 && result_.frames >= options_.maxFrames && !frameOutput_;
  }
  void compareNoMore() { compares_ = false; }
  void finish() {
    if (frameLoop_) result_.scriptError = frameLoop_->scriptError();
  }

 private:
  Status configure(const LogMessage& message) {
    const auto config = std::make_unique<AgentConfig>();
    const Status read = decodeAs(message, *config);
    if (!read) return read;
    if (frameLoop_) return Error{std::string("a second ") + kConfigTopic};
    if (options_.adjust) options_.adjust(*config);
    config->behaviour.reload = false;  // the scripts of the recording, unchanged to its end
    frameLoop_ = std::make_unique<FrameLoop>(*config, options_.scripts);
    motionLoop_ = std::make_unique<MotionLoop>(*config);
    if (!frameLoop_->scriptError().empty()) return Error{frameLoop_->scriptError()};
    return Done{};
  }
  Status frameIn(const LogMessage& message) {
    const Status read = decodeFrameInput(message, input_);
    if (!read) return read;
    withoutImage_ = message.topic() == kPictureFrameTopic;
    if (!withoutImage_) step();
    return Done{};
  }
  // Runs the stages on input_, from the recorded percepts when the image was not kept.
  void step() {
    observer_.beginFrame();
    frameOutput_ = withoutImage_ ? &frameLoop_->stepFrom(recordedFrame_.percepts, input_, observer_)
                                 : &frameLoop_->step(input_, observer_);
    observer_.endFrame();
    ++result_.frames;
    result_.framesFromPercepts += withoutImage_ ? 1 : 0;
    withoutImage_ = false;
    if (options_.onFrame) options_.onFrame(input_, *frameOutput_);
  }
  Status frameOut(const LogMessage& message) {
    const Status read = decodeAs(message, recordedFrame_);
    if (!read) return read;
    if (withoutImage_) step();
    if (frameOutput_ == nullptr) return read;
    compare("frame " + std::to_string(input_.frame), recordedFrame_, *frameOutput_);
    frameOutput_ = nullptr;
    return Done{};
  }
  Status motionIn(const LogMessage& message) {
    const Status read = decodeAs(message, motionInput_);
    if (!read) return read;
    motionOutput_ = &motionLoop_->step(motionInput_, observer_);
    ++result_.motionSteps;
    return Done{};
  }
  Status motionOut(const LogMessage& message) {
    const Status read = decodeAs(message, recordedMotion_);
    if (!read || motionOutput_ == nullptr) return read;
    compare("motion at " + std::to_string(motionInput_.time.us) + " us", recordedMotion_,
            *motionOutput_);
    motionOutput_ = nullptr;
    return Done{};
  }
  template <class T>
  void compare(const std::string& what, const T& recorded, const T& now) {
    std::string path;
    if (!compares_) return;
    ++result_.compared;
    if (!firstDifference(recorded, now, &path)) return;
    ++result_.differing;
    if (result_.differences.size() < kShownDifferences)
      result_.differences.push_back(what + ": " + path);
  }

  const ReplayOptions& options_;
  StageObserver& observer_;
  ReplayResult& result_;
  std::unique_ptr<FrameLoop> frameLoop_;
  std::unique_ptr<MotionLoop> motionLoop_;
  FrameInput input_;
  MotionInput motionInput_;
  bool compares_ = true;
  bool withoutImage_ = false;  // input_ waits for its recorded percepts
  FrameOutput recordedFrame_;
  MotionOutput recordedMotion_;
  const FrameOutput* frameOutput_ = nullptr;    // made, not yet compared
  const MotionOutput* motionOutput_ = nullptr;  // made, not yet compared
};

// Of those that a replay reads, what the log does not have: "/config, /frame/input".
std::string missingTopics(const LogReader& reader) {
  std::string missing;
  for (const char* topic :
       {kConfigTopic, kFrameInputTopic, kFrameOutputTopic, kMotionInputTopic, kMotionOutputTopic}) {
    const auto& channels = reader.channels();
    const bool there = std::any_of(channels.begin(), channels.end(),
                                   [&](const auto& it) { return it.second.topic == topic; });
    if (!there) missing += (missing.empty() ? "" : ", ") + std::string(topic);
  }
  return missing.empty() ? "their messages" : missing;
}

}  // namespace

Expected<ReplayResult> replay(const std::string& log, const ReplayOptions& options,
                              StageObserver& observer) {
  auto reader = LogReader::open(log);
  if (!reader) return Error{reader.error()};
  ReplayResult result;
  const auto player = std::make_unique<Player>(options, observer, result);
  LogMessage message;
  while (!player->enough() && reader->next(message)) {
    if (!reader->gaps().empty()) player->compareNoMore();
    const Status taken = player->take(message);
    if (!taken) return Error{log + ": " + taken.error()};
  }
  if (!reader->status()) return Error{reader->status().error()};
  player->finish();
  result.notes = reader->notes();
  result.lacks = reader->lacks();
  if (result.frames + result.motionSteps == 0)
    return Error{log + ": holds no frames of an agent; it lacks " + missingTopics(*reader)};
  return result;
}

}  // namespace kelpie::agent
