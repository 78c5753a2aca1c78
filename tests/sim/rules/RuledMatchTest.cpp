// SPDX-License-Identifier: Apache-2.0
// Whole matches by the rules, by hand: what the referee orders is done, nothing else moves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "robot/core/Random.h"
#include "robot/core/fields/FieldCheck.h"
#include "tests/sim/rules/Scenes.h"
#include "tools/sim/rules/RuledMatch.h"

namespace kelpie::sim {
namespace {

constexpr Point2<Field> kCentre{180.0, 270.0};

struct Match {
  body::FieldDescription field = ruleField();
  MadeScene scene;
  Score score;
  RuledMatch match;
  std::vector<MatchEvent> events;

  explicit Match(double halfTime = 600.0) : match(withHalf(halfTime), clockFor(kRed)) {
    field = withHalf(halfTime);
    for (const TeamColour team : {kRed, kBlue})
      for (std::uint8_t number = 1; number <= 4; ++number) {
        const Point2<Field> place{80.0 * number - 20.0, number == 1 ? 30.0 : 180.0};
        const Pose2 pose{place, Angle::deg(90.0)};
        scene.with(team, number, {});
        scene.players[scene.players.size() - 1].pose = ownView(field, team, pose);
      }
  }
  static body::FieldDescription withHalf(double halfTime) {
    body::FieldDescription field = ruleField();
    field.rules.halfTime = halfTime;
    return field;
  }
  void tick() {
    scene.time = scene.time + TimeUs{kTickUs};
    const Verdict verdict = match.step(scene, score);
    if (verdict.ball) scene.ball = *verdict.ball;
    for (const Carry& one : verdict.carries) scene.players[one.robot].pose = one.place;
    for (const MatchEvent& event : match.takeEvents()) events.push_back(event);
  }
  void goOn(double seconds) {
    scene.goesOn(seconds, [&](MadeScene& now) {
      now.time = now.time - TimeUs{kTickUs};
      tick();
    });
  }
  bool until(PlayState state) {
    for (int i = 0; i < 20000 && match.clock().state != state; ++i) tick();
    return match.clock().state == state;
  }
  const MatchEvent* last(EventKind kind) const {
    const auto it = std::find_if(events.rbegin(), events.rend(),
                                 [kind](const MatchEvent& event) { return event.kind == kind; });
    return it == events.rend() ? nullptr : &*it;
  }
};

TEST(RuledMatch, TheWhistleComesAfterReadyAndSetWithTheBallInTheMiddle) {
  Match match;
  match.scene.ball.position = {30, 30};
  ASSERT_TRUE(match.until(PlayState::ready));
  EXPECT_NEAR(match.scene.time.seconds(), 5.0, 0.02);
  ASSERT_TRUE(match.until(PlayState::set));
  EXPECT_NEAR(match.scene.time.seconds(), 7.0, 0.05);
  match.scene.ball.position = {30, 30};  // somebody walks into it
  match.tick();
  EXPECT_EQ(distance(match.scene.ball.position, kCentre), 0.0);
  ASSERT_TRUE(match.until(PlayState::playing));
  EXPECT_NEAR(match.scene.time.seconds(), 10.0, 0.05);
  EXPECT_EQ(match.last(EventKind::placed), nullptr);
}

TEST(RuledMatch, FromPlayTheBallStaysWhereItIsAndThereIsOneHalf) {
  MadeScene scene;
  scene.with(kRed, 2, {100.0, 100.0});
  scene.ball = {{60.0, 320.0}, {}};
  Score score;
  RuledMatch match(Match::withHalf(2.0), clockInPlay(kRed));
  for (int i = 0; i < 100; ++i) {
    scene.time = scene.time + TimeUs{kTickUs};
    EXPECT_FALSE(match.step(scene, score).ball);
    EXPECT_EQ(match.clock().state, PlayState::playing);
  }
  while (scene.time.seconds() < 2.1) {
    scene.time = scene.time + TimeUs{kTickUs};
    match.step(scene, score);
  }
  EXPECT_TRUE(match.finished());
}

TEST(RuledMatch, WhoStandsWhereItMayNotIsPutElsewhereByHand) {
  Match match;
  match.scene.players[2].pose.position = {180, 400};
  ASSERT_TRUE(match.until(PlayState::set));
  EXPECT_NEAR(match.scene.time.seconds(), 50.0, 0.05) << "all of the ready state";
  const MatchEvent* placed = match.last(EventKind::placed);
  ASSERT_NE(placed, nullptr);
  EXPECT_EQ(placed->team, kRed);
  EXPECT_EQ(placed->player, 3);
  EXPECT_EQ(placed->place.y, 400.0);
  EXPECT_TRUE(standsLegally(match.field, match.scene.players[2], kRed));
}

struct Scored {
  const char* fact;
  std::optional<std::size_t> toucher;  // 0 to 3 red, 4 to 7 blue
  double goalY;
  TeamColour team;
  bool own;
};

constexpr Scored kScored[] = {
    {"red scores", 1, 545, kRed, false},
    {"blue scores", 5, -5, kBlue, false},
    {"blue into its own goal", 5, 545, kRed, true},
    {"red into its own goal", 2, -5, kBlue, true},
    {"nobody known", std::nullopt, 545, kRed, false},
};

TEST(RuledMatch, AGoalIsTheTeamsWhoseGoalItIsNot) {
  for (const Scored& scored : kScored) {
    Match match;
    ASSERT_TRUE(match.until(PlayState::playing));
    match.tick();
    match.scene.ballToucher = scored.toucher;
    match.tick();
    match.scene.ballToucher.reset();
    match.scene.ball = {{180, scored.goalY}, {}};
    match.tick();
    ASSERT_EQ(match.score.goals.size(), 1U) << scored.fact;
    EXPECT_EQ(match.score.goals[0].team, scored.team) << scored.fact;
    EXPECT_EQ(match.score.goals[0].own, scored.own) << scored.fact;
    EXPECT_EQ(match.score.red, scored.team == kRed ? 1 : 0) << scored.fact;
    EXPECT_EQ(match.match.clock().kickOff, otherTeam(scored.team)) << scored.fact;
    EXPECT_EQ(match.match.clock().state, PlayState::ready) << scored.fact;
    EXPECT_EQ(distance(match.scene.ball.position, kCentre), 0.0) << scored.fact;
    EXPECT_EQ(match.last(EventKind::goal)->reason.view(), scored.own ? "own goal" : "");
  }
}

TEST(RuledMatch, WhoPlaysASavedShotIntoTheOtherGoalHasScored) {
  Match match;
  ASSERT_TRUE(match.until(PlayState::playing));
  match.tick();
  match.scene.ballToucher = 5;
  match.scene.ball = {{180, 60}, {0, -100}};  // blue's shot at the red goal
  match.tick();
  match.scene.ballToucher = 0;
  match.scene.ball = {{180, 58}, {0, 300}};
  match.tick();
  match.scene.ballToucher.reset();
  match.scene.ball = {{180, 545}, {}};
  match.tick();
  ASSERT_EQ(match.score.goals.size(), 1U);
  EXPECT_FALSE(match.score.goals[0].own);
  EXPECT_EQ(match.score.goals[0].player, 1);
}

TEST(RuledMatch, APenalisedRobotWaitsBesideTheFieldAndComesBackAtTheHalfWayLine) {
  Match match;
  ASSERT_TRUE(match.until(PlayState::playing));
  match.scene.players[3].pose.position = {180, 30};
  match.goOn(1.1);
  ASSERT_NE(match.last(EventKind::penalty), nullptr);
  EXPECT_EQ(match.last(EventKind::penalty)->reason.view(), "illegal defender");
  EXPECT_EQ(match.last(EventKind::penalty)->player, 4);
  EXPECT_EQ(match.score.penalties[0][0], 1);
  EXPECT_TRUE(match.match.gameFor(3, match.score).penalised);
  EXPECT_FALSE(match.match.gameFor(2, match.score).penalised);
  EXPECT_GT(body::carpetDistance(match.field, match.scene.players[3].pose.position), 20.0);
  match.scene.ball.position.x = 100;
  match.goOn(29.8);
  EXPECT_TRUE(match.match.penalised(3));
  match.goOn(0.3);
  EXPECT_FALSE(match.match.penalised(3));
  ASSERT_NE(match.last(EventKind::back), nullptr);
  const Pose2& pose = match.scene.players[3].pose;
  EXPECT_EQ(pose.position.y, 270.0);
  EXPECT_EQ(pose.position.x, 345.0) << "the end that is farther from the ball";
  EXPECT_NEAR(std::fabs(pose.heading.deg()), 180.0, 1e-9);
}

TEST(RuledMatch, WhoWalksAwayWhileItIsPenalisedIsCarriedBack) {
  Match match;
  ASSERT_TRUE(match.until(PlayState::playing));
  match.scene.players[3].pose.position = {180, 30};
  match.goOn(1.1);
  const Point2<Field> waits = match.scene.players[3].pose.position;
  match.scene.players[3].pose.position = kCentre;
  match.tick();
  EXPECT_EQ(distance(match.scene.players[3].pose.position, waits), 0.0);
  EXPECT_EQ(match.score.penalties[0][0], 1);
}

TEST(RuledMatch, NobodyComesBackInSetAndHalfTimeEndsAllPenalties) {
  PenaltyState state;
  MadeScene scene;
  scene.with(kRed, 2, {});
  const auto field = ruleField();
  scene.players[0].pose = waitingPlace(field, scene.players[0]);
  state.of[0] = {true, {1000000}, Offence::fallen};
  scene.time = {2000000};
  EXPECT_TRUE(step(scene, PlayState::set, field, state).back.empty());
  EXPECT_EQ(step(scene, PlayState::ready, field, state).back.size(), 1U);
  state.of[0] = {true, {9000000}, Offence::fallen};
  EXPECT_TRUE(step(scene, PlayState::playing, field, state).back.empty());
  EXPECT_EQ(step(scene, PlayState::initial, field, state).back.size(), 1U);
}

TEST(RuledMatch, WaitingAndReturningRobotsDoNotStandInEachOther) {
  MadeScene scene;
  const auto field = ruleField();
  for (const TeamColour team : {kRed, kBlue})
    for (std::uint8_t number = 1; number <= 4; ++number) scene.with(team, number, {});
  for (auto& player : scene.players) player.pose = waitingPlace(field, player);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_TRUE(isFree(scene, scene.players[i].pose.position, 40.0, i)) << i;
  for (std::size_t i = 0; i < 8; ++i) scene.players[i].pose = returnPlace(field, scene, i);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_TRUE(isFree(scene, scene.players[i].pose.position, 39.9, i)) << i;
}

TEST(RuledMatch, ABallOutIsThrownInAndNamesTheTeamThatTouchedItLast) {
  Match match;
  ASSERT_TRUE(match.until(PlayState::playing));
  match.scene.ballToucher = 6;
  match.tick();
  match.scene.ballToucher.reset();
  match.scene.ball = {{-6, 300}, {-20, 0}};
  match.tick();
  const MatchEvent* out = match.last(EventKind::out);
  ASSERT_NE(out, nullptr);
  EXPECT_EQ(out->team, kBlue);
  EXPECT_EQ(out->player, 3);
  EXPECT_EQ(out->place.x, 40.0);
  EXPECT_EQ(match.scene.ball.position.x, 40.0);
  EXPECT_EQ(match.scene.ball.velocity.norm(), 0.0);
  EXPECT_EQ(match.score.outs, 1);
  match.goOn(2.0);
  const net::GameControlData data = match.match.control(match.score);
  EXPECT_EQ(data.dropInTeam, kBlue);
  EXPECT_EQ(data.dropInSeconds, 2U);
}

TEST(RuledMatch, AStuckBallIsPutElsewhereAndPlayGoesOn) {
  Match match;
  ASSERT_TRUE(match.until(PlayState::playing));
  match.scene.players[1].pose.position = {180, 235};
  match.goOn(25.2);
  ASSERT_NE(match.last(EventKind::stuck), nullptr);
  EXPECT_EQ(match.scene.ball.position.x, 320.0);
  EXPECT_EQ(match.match.clock().state, PlayState::playing);
  EXPECT_EQ(match.score.stuck, 1);
}

TEST(RuledMatch, NothingIsCalledBeforeTheWhistle) {
  Match match;
  ASSERT_TRUE(match.until(PlayState::ready));
  match.scene.players[1].pose.position = {180, 30};
  match.scene.ball.position = {180, 560};
  match.goOn(10.0);
  EXPECT_EQ(match.last(EventKind::penalty), nullptr);
  EXPECT_TRUE(match.score.goals.empty());
}

TEST(RuledMatch, WhatTheGameControllerSendsIsWhatTheRobotsHear) {
  Match match;
  const auto same = [&match] {
    const auto bytes = encodeControl(match.match.control(match.score));
    net::GameControlData data;
    ASSERT_FALSE(net::decodeControl(bytes.data(), bytes.size(), data));
    for (std::size_t i = 0; i < match.scene.players.size(); ++i) {
      const ScenePlayer& who = match.scene.players[i];
      GameState reported = match.match.gameFor(i, match.score);
      GameState heard = gameStateFrom(data, who.team, who.number);
      const bool ready = reported.state == PlayState::ready;
      EXPECT_TRUE(ready || std::fabs(heard.secondsLeft - reported.secondsLeft) <= 1.0) << "whole s";
      heard.secondsLeft = reported.secondsLeft;
      std::string path;
      EXPECT_FALSE(firstDifference(reported, heard, &path)) << path;
    }
  };
  match.tick();
  for (const PlayState state : {PlayState::ready, PlayState::set, PlayState::playing}) {
    ASSERT_TRUE(match.until(state));
    same();
  }
  match.scene.players[3].pose.position = {180, 30};
  match.goOn(1.1);
  match.scene.ball.position = {180, 545};
  same();
  match.tick();
  same();
}

TEST(RuledMatch, TwoHalvesThenItIsFinishedAndNothingIsCalledAnyMore) {
  Match match(20.0);
  for (int half = 0; half < 2; ++half) {
    ASSERT_TRUE(match.until(PlayState::playing));
    EXPECT_EQ(match.match.clock().kickOff, half == 0 ? kRed : kBlue);
    EXPECT_EQ(match.match.gameFor(0, match.score).firstHalf, half == 0);
    match.scene.players[3].pose.position = {180, 30};  // its penalty outlasts the half
    match.goOn(20.1);
  }
  EXPECT_TRUE(match.match.finished());
  EXPECT_NEAR(match.scene.time.seconds(), 2.0 * (5.0 + 2.0 + 3.0 + 20.0), 0.3);
  const std::size_t events = match.events.size();
  match.scene.ball.position = {180, 545};
  match.goOn(40.0);
  EXPECT_EQ(match.events.size(), events);
  EXPECT_EQ(match.events.front().kind, EventKind::start);
  EXPECT_EQ(match.events.back().kind, EventKind::end);
}

TEST(RuledMatch, WhatWasBeforeTheWhistleIsNoFoul) {
  Match match;
  ASSERT_TRUE(match.until(PlayState::playing));
  match.scene.players[2].upright = false;
  match.goOn(15.0);
  match.scene.ball.position = {180, 545};
  match.tick();
  ASSERT_TRUE(match.until(PlayState::playing));
  match.goOn(19.0);
  EXPECT_EQ(match.last(EventKind::penalty), nullptr);
  match.goOn(1.1);
  ASSERT_NE(match.last(EventKind::penalty), nullptr);
  EXPECT_EQ(match.last(EventKind::penalty)->reason.view(), "fallen");
}

// The box since one second and the ball since three, called in the same tick.
TEST(RuledMatch, TwoFoulsAtOnceAreOnePenalty) {
  Match match;
  ASSERT_TRUE(match.until(PlayState::playing));
  Pose2& pose = match.scene.players[1].pose;
  const auto holds = [&](double y, int ticks) {
    pose = {{180, y}, Angle::deg(90.0)};
    for (int i = 0; i < ticks; ++i) {
      match.scene.ball = {{180, y + 8.0}, {}};
      match.tick();
    }
  };
  holds(70, 250);
  holds(60, 127);
  const auto& counts = match.score.penalties[0];
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0), 1);
}

// Whatever robots and ball do.
void disturb(MadeScene& scene, Random& random) {
  for (ScenePlayer& player : scene.players) {
    player.pose.position.x += random.uniform(-0.3, 0.3);
    player.pose.position.y += random.uniform(-0.3, 0.3);
    if (random.chance(2e-4))
      player.pose = {{random.uniform(-70, 430), random.uniform(-80, 620)},
                     Angle::rad(random.uniform(-3.0, 3.0))};
    if (random.chance(1e-4)) player.upright = !player.upright;
  }
  if (random.chance(1e-3)) scene.ball.velocity = {random.uniform(-99, 99), random.uniform(-99, 99)};
  if (random.chance(3e-4)) scene.ball.position = {180, random.uniform(-20, 560)};
  scene.ball.position = scene.ball.position + scene.ball.velocity * kTickSeconds;
}

TEST(RuledMatch, WhateverHappensThereIsAWayOn) {
  Random random(31);
  std::map<EventKind, int> calls;
  int finished = 0;
  for (int ticks = 0; ticks < 100000; ++finished) {
    Match match(60.0);
    for (; ticks < 100000 && !match.match.finished(); ++ticks) {
      disturb(match.scene, random);
      match.tick();
      const ClockState& clock = match.match.clock();
      const double longest = clock.state == PlayState::initial ? 5.0
                             : clock.state == PlayState::ready ? 45.0
                             : clock.state == PlayState::set   ? 3.0
                                                               : 60.0;
      ASSERT_LT(clock.inState(), longest + 0.02);
      for (std::size_t i = 0; i < 8; ++i) {
        const Point2<Field> p = match.scene.players[i].pose.position;
        ASSERT_TRUE(!match.match.penalised(i) || body::carpetDistance(match.field, p) > 0.0);
      }
    }
    for (const MatchEvent& event : match.events) {
      std::string why;
      ASSERT_TRUE(verify(event, &why)) << why;
      ++calls[event.kind];
    }
    EXPECT_GE(calls[EventKind::penalty], calls[EventKind::back]);
  }
  EXPECT_GE(finished, 2);
  for (int kind = 0; kind <= 11; ++kind)
    EXPECT_TRUE(kind == 10 || calls[static_cast<EventKind>(kind)] > 0) << kind;
}

}  // namespace
}  // namespace kelpie::sim
