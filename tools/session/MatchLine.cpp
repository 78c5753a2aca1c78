// SPDX-License-Identifier: Apache-2.0
#include "tools/session/MatchLine.h"

#include <fmt/core.h>

#include <algorithm>

#include "tools/cli/Terminal.h"

namespace kelpie::cli {
namespace {

constexpr auto kBetweenDrawn = std::chrono::milliseconds(500);
constexpr auto kBetweenLines = std::chrono::seconds(10);

std::string minutes(double seconds) {
  const int whole = static_cast<int>(seconds);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

std::string matchLine(const MatchTime& now, double length, double took) {
  const double half = 0.5 * length;
  const double played = (now.firstHalf ? 0.0 : half) + std::max(0.0, half - now.left);
  return fmt::format("{} of {}  {} half, {}  red {} : {} blue  {:.1f} x real time", minutes(played),
                     minutes(length), now.firstHalf ? "first" : "second", now.state, now.red,
                     now.blue, took > 0.0 ? now.seconds / took : 0.0);
}

void MatchProgress::operator()(const MatchTime& now) {
  const auto wall = Clock::now();
  if (!start_) start_ = drawn_ = wall;
  const bool terminal = onTerminal();
  if (wall - drawn_ < (terminal ? Clock::duration(kBetweenDrawn) : Clock::duration(kBetweenLines)))
    return;
  drawn_ = wall;
  const double took = std::chrono::duration<double>(wall - *start_).count();
  const std::string line = matchLine(now, length_, took);
  if (terminal)
    live_(line);
  else
    fmt::print(stderr, "{}\n", line);
}

}  // namespace kelpie::cli
