// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/lag/LagEstimate.h"

#include <cmath>
#include <memory>

#include "gps/Localiser.h"
#include "tools/calibrate/LoggedFrames.h"

namespace kelpie::calibrate {
namespace {

// Comparisons below tell less than what is known of all robots.
constexpr std::uint32_t kMinCompared = 20;

// The lag is to be told by the log, whatever its robot knew before.
void forgetLag(agent::AgentConfig& config) {
  agent::shareField(config);
  gps::LagParams& lag = config.gps.lag;
  lag.initial = 0.0;
  lag.initialSd = gps::LagParams{}.initialSd;
  lag.use = true;
}

// The recorded frames, through a localiser of its own.
class LagListener {
 public:
  explicit LagListener(agent::AgentConfig& config) : config_(config) {}

  Status take(const LogMessage& message) {
    if (agent::isFrameInput(message.topic())) return agent::decodeFrameInput(message, *input_);
    if (message.topic() != kFrameOutputTopic) return Done{};
    const Status done = decodeAs(message, *output_);
    if (done) step();
    return done;
  }

  const LagEstimate& estimate() const { return estimate_; }

 private:
  void step() {
    if (estimate_.frames == 0) forgetLag(config_);
    const double before = state_->pose.lag.variance;
    gps::step({*input_, output_->percepts, output_->body.camera}, config_.gps, *state_);
    const ImageLag& lag = state_->pose.lag;
    if (estimate_.frames++ > 0 && lag.variance < before) ++estimate_.compared;
    estimate_.seconds = lag.seconds;
    estimate_.sd = std::sqrt(lag.variance);
  }

  agent::AgentConfig& config_;
  std::unique_ptr<FrameInput> input_ = std::make_unique<FrameInput>();
  std::unique_ptr<FrameOutput> output_ = std::make_unique<FrameOutput>();
  std::unique_ptr<gps::GpsState> state_ = std::make_unique<gps::GpsState>();
  LagEstimate estimate_;
};

}  // namespace

Expected<LagEstimate> estimateLag(const std::string& path) {
  const auto config = std::make_unique<agent::AgentConfig>();
  LagListener listener(*config);
  std::string lacks;
  const Status read = forEachMessage(
      path, *config, lacks, [&](const LogMessage& message) { return listener.take(message); });
  if (!read) return Error{read.error()};
  LagEstimate estimate = listener.estimate();
  estimate.lacks = lacks;
  if (estimate.compared < kMinCompared)
    return Error{path + ": the head turned over a landmark in " +
                 std::to_string(estimate.compared) + " frames, " + std::to_string(kMinCompared) +
                 " tell something"};
  return estimate;
}

}  // namespace kelpie::calibrate
