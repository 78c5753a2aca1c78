// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>

#include "robot/body/Lights.h"
#include "robot/openr/Ers7Primitives.h"

namespace kelpie::body {
namespace {

constexpr PlayState kStates[] = {PlayState::initial, PlayState::ready, PlayState::set,
                                 PlayState::playing, PlayState::finished};

GameState gameIn(PlayState state, bool penalised = false) {
  GameState game;
  game.state = state;
  game.penalised = penalised;
  return game;
}

// The names of the OPEN-R primitives that are lit.
std::string named(std::uint32_t leds) {
  std::string lit;
  for (std::size_t i = 0; i < openr::kLedCount; ++i)
    if ((leds >> i & 1U) != 0) lit += std::string(openr::kLedLocators[i]).substr(4) + " ";
  return lit;
}

TEST(Lights, EachStateShowsADifferentPattern) {
  std::set<std::uint32_t> patterns;
  for (const PlayState state : kStates) patterns.insert(lights(gameIn(state), Role::none, 0));
  patterns.insert(lights(gameIn(PlayState::playing, true), Role::none, 0));
  EXPECT_EQ(patterns.size(), 6U);
}

TEST(Lights, APenalisedRobotShowsItInEveryState) {
  for (const PlayState state : kStates)
    EXPECT_EQ(lightsOf(state, true), lightsOf(PlayState::playing, true));
}

TEST(Lights, ReadyIsBlueSetYellowPlayingGreenAndPenalisedRed) {
  EXPECT_EQ(named(lightsOf(PlayState::ready, false)), "/r1/c1/c2/c3/l5-LED2:l5 ");
  EXPECT_EQ(named(lightsOf(PlayState::set, false)),
            "/r1/c1/c2/c3/l3-LED2:l3 /r1/c1/c2/c3/l4-LED2:l4 ");
  EXPECT_EQ(named(lightsOf(PlayState::playing, false)), "/r1/c1/c2/c3/l4-LED2:l4 ");
  EXPECT_EQ(named(lightsOf(PlayState::playing, true)), "/r1/c1/c2/c3/l3-LED2:l3 ");
}

TEST(Lights, TheBackShowsTheTeam) {
  EXPECT_EQ(named(lightsOf(TeamColour::red)), "/ly-LED3:ly ");
  EXPECT_EQ(named(lightsOf(TeamColour::blue)), "/lu-LED3:lu ");
}

TEST(Lights, EachRoleHasAPairOfTheFaceOfItsOwn) {
  std::uint32_t all = 0;
  for (std::uint8_t i = 1; i < kRoleCount; ++i) {
    const std::uint32_t pair = lightsOf(static_cast<Role>(i));
    EXPECT_EQ(all & pair, 0U);
    all |= pair;
  }
  EXPECT_EQ(named(lightsOf(Role::attacker)), "/r1/c1/c2/c3/la-LED3:la /r1/c1/c2/c3/lb-LED3:lb ");
  EXPECT_EQ(lightsOf(Role::none), 0U);
}

TEST(Lights, EachReasonToRestShowsADifferentPatternBesideGameAndTeam) {
  std::set<std::uint32_t> patterns;
  for (std::uint8_t i = 0; i < kRestCount; ++i) {
    const std::uint32_t shown = lights(gameIn(PlayState::playing), static_cast<Rest>(i));
    EXPECT_EQ(shown & lightsOf(PlayState::playing, false), lightsOf(PlayState::playing, false));
    EXPECT_EQ(shown & lightsOf(TeamColour::red), lightsOf(TeamColour::red));
    patterns.insert(shown);
  }
  EXPECT_EQ(patterns.size(), kRestCount);
  EXPECT_EQ(named(lightsOf(Rest::batteryLow)), "/r1/c1/c2/c3/lm-LED3:lm ");
  for (std::uint8_t i = 1; i < kRoleCount; ++i)
    EXPECT_EQ(lightsOf(static_cast<Role>(i)) & lightsOf(Rest::paused), 0U);
}

TEST(Lights, BehavioursThatFailedAreALightThatNothingElseShows) {
  const std::uint32_t failed = lightsOf(Fallback::scriptError);
  EXPECT_EQ(lightsOf(Fallback::notLoaded), failed);
  EXPECT_EQ(lightsOf(Fallback::none), 0U);
  EXPECT_EQ(named(failed), "/r1/c1/c2/c3/ll-LED3:ll ");
  for (std::uint8_t i = 0; i < kRestCount; ++i) EXPECT_NE(lightsOf(static_cast<Rest>(i)), failed);
  for (std::uint8_t i = 0; i < kRoleCount; ++i)
    EXPECT_EQ(lightsOf(static_cast<Role>(i)) & failed, 0U);
}

TEST(Lights, WhatBehavioursAskForNeitherHidesNorFakesTheTable) {
  const GameState game = gameIn(PlayState::set);
  const std::uint32_t table = lights(game, Role::striker, 0);
  const std::uint32_t asked = lights(game, Role::striker, 0xffffffffU);
  EXPECT_EQ(asked & table, table);
  EXPECT_EQ(asked & lightsOf(PlayState::finished, false), lightsOf(PlayState::set, false));
  EXPECT_EQ(asked & lightsOf(Role::attacker), 0U);
  EXPECT_EQ(asked & lightsOf(Fallback::scriptError), 0U);
  EXPECT_EQ(lights(game, Role::striker, 1U << 19U), table | 1U << 19U) << "a free light is theirs";
}

TEST(Lights, AFaultGoesOnAndOffAndCountsOnTheFace) {
  const std::uint32_t on = faultLights(3, {0});
  const std::uint32_t off = faultLights(3, {250000});
  EXPECT_EQ(named(on),
            "/r1/c1/c2/c3/l3-LED2:l3 /r1/c1/c2/c3/la-LED3:la /r1/c1/c2/c3/lb-LED3:lb "
            "/r1/c1/c2/c3/lc-LED3:lc ");
  EXPECT_EQ(on & ~kLightRed, off);
  EXPECT_EQ(faultLights(3, {500000}), on);
  EXPECT_EQ(faultLights(200, {0}), faultLights(kFaceLights, {0}));
}

}  // namespace
}  // namespace kelpie::body
