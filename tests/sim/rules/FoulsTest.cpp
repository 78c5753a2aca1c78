// SPDX-License-Identifier: Apache-2.0
// The fouls: of one robot's place, with the ball, and of one robot against another.
#include <gtest/gtest.h>

#include "tests/sim/rules/Scenes.h"
#include "tools/sim/rules/Fouls.h"
#include "tools/sim/rules/Holding.h"
#include "tools/sim/rules/Pushing.h"

namespace kelpie::sim {
namespace {

struct Placed {
  const char* fact;
  TeamColour team;
  std::uint8_t number;
  Point2<Field> place;
  bool upright;
  double seconds;
  std::optional<Offence> offence;
};

constexpr Placed kPlaced[] = {
    {"a forward in its box for 1.1 s", kRed, 2, {180, 30}, true, 1.1, Offence::ownBox},
    {"for 0.9 s", kRed, 2, {180, 30}, true, 0.9, std::nullopt},
    {"in the mouth of its goal", kRed, 4, {180, -10}, true, 2.0, Offence::ownBox},
    {"the goalie in its box", kRed, 1, {180, 30}, true, 60.0, std::nullopt},
    {"a forward in the other's box", kRed, 2, {180, 520}, true, 60.0, std::nullopt},
    {"blue's forward in blue's box", kBlue, 3, {120, 500}, true, 2.0, Offence::ownBox},
    {"beside the box", kBlue, 3, {110, 500}, true, 60.0, std::nullopt},
    {"off the carpet for 1.1 s", kRed, 2, {-21, 200}, true, 1.1, Offence::leftField},
    {"for 0.9 s", kRed, 2, {-21, 200}, true, 0.9, std::nullopt},
    {"on the carpet beside the field", kRed, 2, {-19, 200}, true, 60.0, std::nullopt},
    {"behind the goal line's carpet", kBlue, 1, {300, 571}, true, 2.0, Offence::leftField},
    {"lies for 20.1 s", kRed, 3, {100, 200}, false, 20.1, Offence::fallen},
    {"for 19.9 s", kRed, 3, {100, 200}, false, 19.9, std::nullopt},
};

TEST(Fouls, OfOneRobotsPlace) {
  for (const Placed& placed : kPlaced) {
    MadeScene scene;
    scene.with(placed.team, placed.number, placed.place);
    scene.players[0].upright = placed.upright;
    FoulState state;
    std::optional<Offence> called;
    scene.goesOn(placed.seconds, [&](MadeScene& now) {
      for (const Foul& foul : step(now, ruleField(), state)) called = foul.offence;
    });
    EXPECT_EQ(called, placed.offence) << placed.fact;
  }
}

TEST(Fouls, WhoLeavesInBetweenBeginsAnew) {
  MadeScene scene;
  scene.with(kRed, 2, {180, 30});
  FoulState state;
  const auto field = ruleField();
  const auto judge = [&](MadeScene& now) { return step(now, field, state); };
  EXPECT_EQ(scene.callsIn(0.9, judge), 0U);
  scene.players[0].pose.position.y = 80;
  EXPECT_EQ(scene.callsIn(0.1, judge), 0U);
  scene.players[0].pose.position.y = 30;
  EXPECT_EQ(scene.callsIn(0.9, judge), 0U);
  scene.players[0].playing = false;
  EXPECT_EQ(scene.callsIn(5.0, judge), 0U) << "a robot off the field commits none";
}

struct Held {
  const char* fact;
  double seconds;
  double speed;  // cm/s
  std::optional<Offence> offence;
};

constexpr Held kHeld[] = {
    {"2.9 s", 2.9, 0.0, std::nullopt},
    {"3.1 s", 3.1, 0.0, Offence::heldTooLong},
    {"45 cm", 2.25, 20.0, std::nullopt},
    {"54 cm", 2.7, 20.0, Offence::carriedTooFar},
};

TEST(Fouls, TheBallIsHeldForThreeSecondsAndFiftyCentimetresAtMost) {
  for (const Held& held : kHeld) {
    MadeScene scene;
    scene.with(kBlue, 2, {100, 200}).with(kRed, 2, {100, 400});
    HoldingState state;
    Fouls called;
    scene.goesOn(held.seconds, [&](MadeScene& now) {
      Pose2& pose = now.players[0].pose;
      pose.position.y += held.speed * kTickSeconds;
      now.ball.position = fieldFromRobot(pose, {0.0, 8.0});
      if (called.empty()) called = step(now, body::Rules{}, state);
    });
    ASSERT_EQ(called.size(), held.offence ? 1U : 0U) << held.fact;
    if (!held.offence) continue;
    EXPECT_EQ(called[0].player, 0U) << held.fact;
    EXPECT_EQ(called[0].offence, *held.offence) << held.fact;
  }
}

struct PushCase {
  const char* fact;
  double oneSpeed;    // cm/s up-field of a red robot
  double otherSpeed;  // of a robot ahead of it
  double gap;         // cm between the neck bases at first
  double seconds;
  std::optional<std::size_t> pusher;
};

constexpr PushCase kPushes[] = {
    {"4.1 s of pushing", 10, 10, 30, 4.1, 0},
    {"2.9 s", 10, 10, 30, 2.9, std::nullopt},
    {"who does not give way is not pushed", 3, 0, 30, 4.1, std::nullopt},
    {"who stands pushes nobody", 0, 3, 19, 4.1, std::nullopt},
    {"nobody is touched at 45 cm", 10, 10, 45, 10.0, std::nullopt},
    {"of two the one that gives way is pushed", -10, -10, 30, 4.1, 1},
};

std::optional<std::size_t> pusherIn(MadeScene& scene, const PushCase& push) {
  PushingState state;
  std::optional<std::size_t> pusher;
  const auto field = ruleField();
  scene.goesOn(push.seconds, [&](MadeScene& now) {
    now.players[0].pose.position.y += push.oneSpeed * kTickSeconds;
    now.players[1].pose.position.y += push.otherSpeed * kTickSeconds;
    for (const Foul& foul : step(now, field, state)) pusher = foul.player;
  });
  return pusher;
}

MadeScene faceToFace(TeamColour other, double gap) {
  MadeScene scene;
  scene.with(kRed, 2, {60, 200}).with(other, 2, {60, 200 + gap}, -90);
  scene.ball.position = {300, 100};
  return scene;
}

TEST(Fouls, WhoPushesAnotherForThreeSeconds) {
  for (const PushCase& push : kPushes) {
    MadeScene scene = faceToFace(kBlue, push.gap);
    EXPECT_EQ(pusherIn(scene, push), push.pusher) << push.fact;
  }
}

TEST(Fouls, NoPushIsAFoulAtTheBallByAGoalieInItsBoxOrAmongMates) {
  const PushCase& push = kPushes[0];
  MadeScene mates = faceToFace(kRed, push.gap);
  EXPECT_FALSE(pusherIn(mates, push));
  MadeScene goalie = faceToFace(kBlue, push.gap);
  goalie.players[0].number = kGoalie;
  EXPECT_TRUE(pusherIn(goalie, push));
  goalie = faceToFace(kBlue, push.gap);
  goalie.players[0].number = kGoalie;
  for (ScenePlayer& player : goalie.players) {
    player.pose.position = player.pose.position + Point2<Field>{120, -185};
  }
  EXPECT_FALSE(pusherIn(goalie, push));
  MadeScene ball = faceToFace(kBlue, push.gap);
  ball.ball.position = {80, 235};
  EXPECT_FALSE(pusherIn(ball, push));
}

}  // namespace
}  // namespace kelpie::sim
