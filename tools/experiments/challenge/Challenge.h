// SPDX-License-Identifier: Apache-2.0
// The 2004 localisation challenge (thesis 2004 section 4.1) as it is played: a minute to map
// unknown sheets on the outer wall; then landmarks are hidden and the robot is carried away; two
// minutes to reach five points. Wall, sheets, places and points come from the seed.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "tools/experiments/pose/LocaliseMatch.h"

namespace kelpie::experiments {

constexpr double kStage1 = 60.0;  // s
constexpr double kHalt = 2.0;
constexpr double kStage2 = 120.0;
constexpr std::size_t kPoints = 5;

using Points = std::vector<Point2<Field>>;

struct Challenge {
  sim::OuterWall wall;
  Points points;
  Pose2 start;
  Pose2 carried;
  std::array<double, 8> measured{};  // the wall's corners, as the robot is told
};

Challenge challengeOf(const body::FieldDescription& field, std::uint64_t seed);

struct ChallengeRun {
  agent::AgentConfig config;  // of the robot; the challenge adds what it tells it
  std::uint64_t seed = 1;
  cli::RandomisationOptions randomised;
};

// Called with each frame; `mapped` once between the stages, and `over` after each second of the
// second one: true ends it. Either may be empty.
struct ChallengeWatch {
  LocaliseMatch::Watcher frame;
  std::function<void()> mapped;
  std::function<bool()> over;
};
Status playChallenge(const ChallengeRun& run, const Challenge& challenge,
                     const ChallengeWatch& watch);

}  // namespace kelpie::experiments
