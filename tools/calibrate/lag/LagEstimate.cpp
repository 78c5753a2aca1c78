// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/lag/LagEstimate.h"

#include <cmath>
#include <memory>

#include "gps/Localiser.h"
#include "robot/agent/log/FrameMessages.h"
#include "robot/core/log/LogReader.h"

namespace kelpie::calibrate {
namespace {

// Comparisons below tell less than what is known of all robots.
constexpr std::uint32_t kMinCompared = 20;

// The recorded frames, through a localiser of its own.
class LagListener {
 public:
  Status take(const LogMessage& message) {
    const std::string& topic = message.topic();
    if (topic == kConfigTopic) return configure(message);
    if (agent::isFrameInput(topic)) return agent::decodeFrameInput(message, *input_);
    if (topic != kFrameOutputTopic || !configured_) return Done{};
    const Status done = decodeAs(message, *output_);
    if (done) step();
    return done;
  }

  bool configured() const { return configured_; }
  const LagEstimate& estimate() const { return estimate_; }

 private:
  Status configure(const LogMessage& message) {
    const Status done = decodeAs(message, *config_);
    configured_ = done.ok();
    config_->gps.field = config_->field;
    gps::LagParams& lag = config_->gps.lag;
    lag.initial = 0.0;
    lag.initialSd = gps::LagParams{}.initialSd;
    lag.use = true;
    return done;
  }

  void step() {
    const double before = state_->pose.lag.variance;
    gps::step({*input_, output_->percepts, output_->body.camera}, config_->gps, *state_);
    const ImageLag& lag = state_->pose.lag;
    ++estimate_.frames;
    if (estimate_.frames > 1 && lag.variance < before) ++estimate_.compared;
    estimate_.seconds = lag.seconds;
    estimate_.sd = std::sqrt(lag.variance);
  }

  std::unique_ptr<agent::AgentConfig> config_ = std::make_unique<agent::AgentConfig>();
  std::unique_ptr<FrameInput> input_ = std::make_unique<FrameInput>();
  std::unique_ptr<FrameOutput> output_ = std::make_unique<FrameOutput>();
  std::unique_ptr<gps::GpsState> state_ = std::make_unique<gps::GpsState>();
  bool configured_ = false;
  LagEstimate estimate_;
};

}  // namespace

Expected<LagEstimate> estimateLag(const std::string& path) {
  auto reader = LogReader::open(path);
  if (!reader) return Error{reader.error()};
  LagListener listener;
  LogMessage message;
  while (reader->next(message)) {
    const Status done = listener.take(message);
    if (!done) return Error{path + ": " + done.error()};
  }
  if (!reader->status()) return Error{reader->status().error()};
  if (!listener.configured()) return Error{path + ": not a log of an agent"};
  LagEstimate estimate = listener.estimate();
  estimate.lacks = reader->lacks();
  if (estimate.compared < kMinCompared)
    return Error{path + ": the head turned over a landmark in " +
                 std::to_string(estimate.compared) + " frames, " + std::to_string(kMinCompared) +
                 " tell something"};
  return estimate;
}

}  // namespace kelpie::calibrate
