// SPDX-License-Identifier: Apache-2.0
#include "tools/broadcast/Captions.h"

#include "tools/match/EventWords.h"

namespace kelpie::broadcast {
namespace {

constexpr double kBannerSeconds = 3.0;

std::string capital(std::string words) {
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z')
    words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

std::string wordsOf(const sim::MatchEvent& event) { return capital(match::sentenceOf(event)); }

}  // namespace

std::string nameOf(TeamColour team, int player) {
  return (team == TeamColour::red ? "red " : "blue ") + std::to_string(player);
}

std::string ballWords(const Actor* holder, bool ballThere) {
  if (!ballThere) return "The ball is away";
  if (holder == nullptr) return "Nobody has the ball";
  return capital(nameOf(holder->team, holder->player)) + " has the ball";
}

std::string bannerAt(const std::vector<sim::MatchEvent>& events, double seconds) {
  std::string words;
  for (const sim::MatchEvent& event : events) {
    const double since = seconds - event.time.seconds();
    const bool plain = event.kind == sim::EventKind::start || event.kind == sim::EventKind::placed;
    if (!plain && since >= 0.0 && since <= kBannerSeconds) words = wordsOf(event);
    if (event.kind == sim::EventKind::goal && since >= 0.0 && since <= kBannerSeconds) return words;
  }
  return words;
}

std::vector<Call> callsUntil(const std::vector<sim::MatchEvent>& events, double seconds,
                             std::size_t count) {
  std::vector<Call> calls;
  for (auto event = events.rbegin(); event != events.rend() && calls.size() < count; ++event)
    if (event->time.seconds() <= seconds) calls.push_back({event->time.seconds(), wordsOf(*event)});
  return calls;
}

}  // namespace kelpie::broadcast
