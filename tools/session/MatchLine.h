// SPDX-License-Identifier: Apache-2.0
// How far a match of two teams is, in one line: on a terminal drawn again, at most twice a second;
// elsewhere a line of its own in ten seconds.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "tools/cli/Progress.h"
#include "tools/session/Session.h"

namespace kelpie::cli {

// "3:12 of 10:00  second half, playing  red 1 : 0 blue  5.2 x real time"; `length`: s of play in
// both halves, `took`: s on the clock on the wall.
std::string matchLine(const MatchTime& now, double length, double took);

class MatchProgress {
 public:
  explicit MatchProgress(double length) : length_(length) {}

  void operator()(const MatchTime& now);
  // What else is to be said goes in place of the line, or below it.
  void clear() { live_.clear(); }
  void finish() { live_.finish(); }

 private:
  using Clock = std::chrono::steady_clock;

  double length_;  // s of play
  LiveLine live_;
  std::optional<Clock::time_point> start_;
  Clock::time_point drawn_;
};

}  // namespace kelpie::cli
