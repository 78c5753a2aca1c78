// SPDX-License-Identifier: Apache-2.0
// When a team has found a ball, from made images and true places.
#include <gtest/gtest.h>

#include "tools/experiments/team/TeamSearch.h"

namespace kelpie::experiments {
namespace {

constexpr double kThrown = 2.0;

BallPercept ballAt(double distance, double deg) {
  BallPercept ball;
  ball.present = true;
  ball.distance = distance;
  ball.heading = Angle::deg(deg);
  return ball;
}

// Two red robots and a blue one at the middle line look up the field at a ball 150 cm ahead.
struct MadeSearch {
  TeamMatch match;

  MadeSearch() {
    for (const std::uint8_t player : {std::uint8_t{2}, std::uint8_t{3}})
      match.robots.push_back({TeamColour::red, player, {}});
    match.robots.push_back({TeamColour::blue, 1, {}});
    for (int i = 0; i < 300; ++i) {
      sim::TruthFrame truth;
      truth.time = TimeUs::fromSeconds(i * kFrameSeconds);
      for (const TeamRobot& robot : match.robots)
        truth.robots.push_back({robot.team, robot.player, {{180.0, 270.0}, Angle::deg(90.0)}, {}});
      truth.ball = {180.0, 420.0};
      match.truth.push_back(truth);
    }
  }
  void sees(std::size_t robot, double from, double until, const BallPercept& seen) {
    for (int i = 0; i < 300; ++i) {
      TeamFrame frame;
      frame.seconds = i * kFrameSeconds;
      if (frame.seconds >= from && frame.seconds < until) frame.seen = seen;
      match.robots[robot].frames.push_back(frame);
    }
  }
};

TEST(TeamSearch, TheFirstOfTheTeamWhoSeesTheBallHasFoundIt) {
  MadeSearch search;
  search.sees(0, 7.0, 9.0, ballAt(150.0, 0.0));
  search.sees(1, 5.0, 9.0, ballAt(145.0, 3.0));
  const auto found = foundAfter(search.match, TeamColour::red, kThrown);
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, 3.0, 2.0 * kFrameSeconds);
}

TEST(TeamSearch, NobodyFindsABallWhereItIsNotNorOfTheOtherTeam) {
  MadeSearch search;
  search.sees(0, 0.0, 9.0, ballAt(150.0, 20.0));
  search.sees(1, 0.0, 9.0, ballAt(60.0, 0.0));
  search.sees(2, 0.0, 9.0, ballAt(150.0, 0.0));
  EXPECT_FALSE(foundAfter(search.match, TeamColour::red, kThrown));
  EXPECT_TRUE(foundAfter(search.match, TeamColour::blue, kThrown));
}

TEST(TeamSearch, OneImageIsNotEnough) {
  MadeSearch search;
  search.sees(0, 5.0, 5.0 + 0.5 * kFrameSeconds, ballAt(150.0, 0.0));
  EXPECT_FALSE(foundAfter(search.match, TeamColour::red, kThrown));
}

TEST(TeamSearch, WhatWasSeenBeforeTheThrowDoesNotCount) {
  MadeSearch search;
  search.sees(0, 0.0, kThrown, ballAt(150.0, 0.0));
  EXPECT_FALSE(foundAfter(search.match, TeamColour::red, kThrown));
}

}  // namespace
}  // namespace kelpie::experiments
