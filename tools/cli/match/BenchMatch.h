// SPDX-License-Identifier: Apache-2.0
// How many times faster than a clock this machine plays: one walking physical robot without camera
// or agent on one core, and a match of processes, one world and an agent a robot, on all cores.
#pragma once

#include <cstdint>

#include "robot/core/Expected.h"

namespace kelpie::cli {

struct MatchBench {
  int robots = 8;
  double seconds = 20.0;  // of the match
  std::uint64_t seed = 1;
  bool physical = true;
};

struct MatchSpeeds {
  double physicsOfOne = 0.0;  // simulated seconds a second of the core's time
  double match = 0.0;         // a second of the clock, without what starting takes
};

// Fails when a process does.
Expected<MatchSpeeds> benchMatch(const MatchBench& bench);

}  // namespace kelpie::cli
