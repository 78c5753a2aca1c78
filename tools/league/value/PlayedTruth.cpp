// SPDX-License-Identifier: Apache-2.0
#include "tools/league/value/PlayedTruth.h"

#include <algorithm>

#include "robot/core/log/LogReader.h"

namespace kelpie::value {
namespace {

using sim::EventKind;

bool begins(EventKind kind, bool ruled) {
  return kind == (ruled ? EventKind::play : EventKind::start) || kind == EventKind::returned;
}

bool ends(EventKind kind) {
  return kind == EventKind::goal || kind == EventKind::half || kind == EventKind::end ||
         kind == EventKind::ready || kind == EventKind::taken;
}

bool isRuled(const PlayedTruth& match) {
  return std::any_of(match.events.begin(), match.events.end(),
                     [](const auto& event) { return event.kind == EventKind::play; });
}

}  // namespace

Expected<PlayedTruth> readTruth(const std::string& path) {
  auto reader = LogReader::open(path);
  if (!reader) return Error{reader.error()};
  PlayedTruth match;
  LogMessage message;
  while (reader->next(message)) {
    sim::TruthFrame truth;
    sim::MatchEvent event;
    if (message.topic() == sim::kTruthTopic && decodeAs(message, truth))
      match.frames.push_back(truth);
    if (message.topic() == sim::kEventTopic && decodeAs(message, event))
      match.events.push_back(event);
  }
  if (!reader->status()) return Error{reader->status().error()};
  if (match.frames.empty()) return Error{path + ": holds no true places of a match"};
  return match;
}

std::vector<Stretch> stretchesOf(const PlayedTruth& match) {
  const bool ruled = isRuled(match);
  std::vector<Stretch> stretches;
  bool inPlay = false;
  double begun = 0.0;
  const auto close = [&](double end, std::optional<TeamColour> goal) {
    if (inPlay && end > begun) stretches.push_back({begun, end, goal});
    inPlay = false;
  };
  for (const sim::MatchEvent& event : match.events) {
    const double now = event.time.seconds();
    const bool goal = event.kind == EventKind::goal;
    if (ends(event.kind)) close(now, goal ? std::optional(event.team) : std::nullopt);
    if (inPlay || !(begins(event.kind, ruled) || (goal && !ruled))) continue;
    inPlay = true;
    begun = now;
  }
  if (!match.frames.empty()) close(match.frames.back().time.seconds(), std::nullopt);
  return stretches;
}

FrameRange framesOf(const PlayedTruth& match, const Stretch& stretch) {
  const auto at = [&](double seconds) {
    return static_cast<std::size_t>(
        std::lower_bound(
            match.frames.begin(), match.frames.end(), seconds,
            [](const sim::TruthFrame& frame, double s) { return frame.time.seconds() < s; }) -
        match.frames.begin());
  };
  return {at(stretch.begin), at(stretch.end)};
}

}  // namespace kelpie::value
