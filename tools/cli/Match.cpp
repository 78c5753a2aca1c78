// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/Match.h"

#include <memory>

#include "robot/agent/Replay.h"
#include "tools/sim/Truth.h"

namespace kelpie::cli {
namespace {

TruePlaces placesOf(const sim::TruthFrame& truth) {
  TruePlaces places;
  places.present = !truth.robots.empty();
  if (places.present) places.robot = truth.robots[0].pose;
  places.ball = truth.ball;
  return places;
}

}  // namespace

Expected<Match> Match::open(const std::string& path) {
  auto reader = LogReader::open(path);
  if (!reader) return Error{reader.error()};
  Match match;
  match.path_ = path;
  bool configured = false;
  LogMessage message;
  while (reader->next(message)) {
    if (message.topic() == agent::kFrameOutputTopic) ++match.frames_;
    if (message.topic() != agent::kConfigTopic) continue;
    const auto config = std::make_unique<agent::AgentConfig>();
    const Status read = decodeAs(message, *config);
    if (!read) return Error{path + ": " + read.error()};
    match.field_ = config->gps.field;
    configured = true;
  }
  if (!reader->status()) return Error{reader->status().error()};
  if (!configured || match.frames_ == 0)
    return Error{path + ": holds no frames with outputs to show"};
  return match;
}

void Match::forEachMoment(const std::function<void(const Moment&)>& show) const {
  auto reader = LogReader::open(path_);
  if (!reader) return;
  const auto input = std::make_unique<FrameInput>();
  const auto output = std::make_unique<FrameOutput>();
  sim::TruthFrame truth;
  TruePlaces places;
  bool inputKnown = false;
  LogMessage message;
  while (reader->next(message)) {
    if (message.topic() == sim::kTruthTopic && decodeAs(message, truth)) places = placesOf(truth);
    if (message.topic() == agent::kFrameInputTopic) inputKnown = decodeAs(message, *input).ok();
    if (message.topic() == agent::kFrameOutputTopic && inputKnown && decodeAs(message, *output))
      show({*input, *output, places});
  }
}

}  // namespace kelpie::cli
