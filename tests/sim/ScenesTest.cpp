// SPDX-License-Identifier: Apache-2.0
// Scenes: what each kind promises, over many seeds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot/body/FieldDescription.h"
#include "tools/sim/staging/Scenes.h"

namespace kelpie::sim {
namespace {

constexpr std::uint64_t kSeeds = 100;

const body::FieldDescription& field() {
  static const body::FieldDescription description = *body::fieldDescription("2006");
  return description;
}

StagedScene drawn(const std::string& kind, std::uint64_t seed) {
  const auto scene = drawScene(kind, field(), seed);
  EXPECT_TRUE(scene) << kind << ": " << scene.error();
  return scene ? *scene : StagedScene{};
}

Pose2 placeOf(const StagedScene& scene, TeamColour team, int number) {
  for (const RobotPlace& place : scene.staging.places)
    if (place.robot.team == team && place.robot.player == number) return place.pose;
  ADD_FAILURE() << "no robot " << number;
  return {};
}

Point2<Field> ballOf(const StagedScene& scene) { return scene.staging.ball->position; }

double apart(const StagedScene& scene, TeamColour team, int number) {
  return distance(placeOf(scene, team, number).position, ballOf(scene));
}

// Each scene of a kind.
template <class Check>
void forScenes(const std::string& kind, Check check) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(kind + " " + std::to_string(seed));
    check(drawn(kind, seed));
  }
}

TEST(Scenes, EveryKindHasRoomOnEveryFieldWithAPlaceForEachRobot) {
  for (const char* name : {"2006", "osaka2005", "2004"})
    for (const std::string& kind : sceneKinds())
      for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        const auto scene = drawScene(kind, *body::fieldDescription(name), seed);
        ASSERT_TRUE(scene) << name << ' ' << kind << ' ' << seed << ": " << scene.error();
        const auto robots = static_cast<std::size_t>(scene->robots[0] + scene->robots[2] - 2 * '0');
        EXPECT_EQ(scene->staging.places.size(), robots);
        EXPECT_GE(scene->seconds, 10.0);
        EXPECT_LE(scene->seconds, 20.0);
      }
}

TEST(Scenes, ASeedIsOneSceneAndAnotherSeedAnotherOne) {
  for (const std::string& kind : sceneKinds()) {
    const Pose2 once = placeOf(drawn(kind, 7), TeamColour::red, 2);
    EXPECT_EQ(once.position.x, placeOf(drawn(kind, 7), TeamColour::red, 2).position.x);
    EXPECT_NE(once.position.x, placeOf(drawn(kind, 8), TeamColour::red, 2).position.x) << kind;
  }
}

TEST(Scenes, NumberOneStandsInItsGoal) {
  for (const std::string& kind : sceneKinds())
    forScenes(kind, [](const StagedScene& scene) {
      EXPECT_LT(placeOf(scene, TeamColour::red, 1).position.y, 30.0);
      if (scene.robots[2] == '0') return;
      EXPECT_GT(placeOf(scene, TeamColour::blue, 1).position.y, field().length - 30.0);
    });
}

double fromMiddle(const StagedScene& scene) {
  return std::fabs(ballOf(scene).x - 0.5 * field().width);
}

TEST(Scenes, ToFinishTheBallIsWithinSixtyCentimetresOfAGuardedGoal) {
  forScenes("finish", [](const StagedScene& scene) {
    EXPECT_EQ(scene.robots, "2v2");
    EXPECT_GE(ballOf(scene).y, field().length - 60.0);
    EXPECT_LE(apart(scene, TeamColour::red, 2), 60.5);
  });
}

TEST(Scenes, BeforeAnOpenLineTheBallIsBetweenThePosts) {
  forScenes("open-line", [](const StagedScene& scene) {
    EXPECT_EQ(scene.robots, "2v0");
    EXPECT_GE(ballOf(scene).y, field().length - 15.0);
    EXPECT_LE(fromMiddle(scene), 0.5 * field().goalWidth - 5.0);
  });
}

TEST(Scenes, AtAPostForwardAndGoalieAreAtTheBall) {
  forScenes("post", [](const StagedScene& scene) {
    EXPECT_LE(std::fabs(fromMiddle(scene) - 0.5 * field().goalWidth), 12.0);
    EXPECT_GE(ballOf(scene).y, field().length - 14.0);
    EXPECT_LE(apart(scene, TeamColour::red, 2), 31.0);
    EXPECT_LE(apart(scene, TeamColour::blue, 1), 40.0);
  });
}

TEST(Scenes, InAJamOneOfEachTeamIsAtABallInTheCorner) {
  forScenes("jam", [](const StagedScene& scene) {
    EXPECT_GE(fromMiddle(scene), 0.5 * field().width - 12.0);
    EXPECT_GE(ballOf(scene).y, field().length - 12.0);
    for (const TeamColour team : {TeamColour::red, TeamColour::blue})
      EXPECT_LE(apart(scene, team, 2), 36.5);
  });
}

TEST(Scenes, AnOpponentAheadIsUpFieldOfTheBall) {
  forScenes("ahead", [](const StagedScene& scene) {
    EXPECT_NEAR(apart(scene, TeamColour::blue, 2), 125.0, 1.1);
    EXPECT_GT(placeOf(scene, TeamColour::blue, 2).position.y, ballOf(scene).y + 120.0);
    EXPECT_LT(placeOf(scene, TeamColour::red, 2).position.y, ballOf(scene).y);
  });
}

TEST(Scenes, AContestedBallIsAsNearToBothWhoFaceIt) {
  forScenes("contested", [](const StagedScene& scene) {
    EXPECT_LE(apart(scene, TeamColour::red, 2), 40.0);
    EXPECT_LE(apart(scene, TeamColour::blue, 2), 40.0);
  });
}

TEST(Scenes, InTheOwnBoxRedDefends) {
  forScenes("own-box", [](const StagedScene& scene) {
    EXPECT_LE(ballOf(scene).y, 90.0);
    EXPECT_GT(placeOf(scene, TeamColour::blue, 2).position.y, ballOf(scene).y);
  });
}

TEST(Scenes, ABallAtTheEdgeOrInTheCornerIsNearTheLines) {
  const auto fromSide = [](Point2<Field> p) { return std::min(p.x, field().width - p.x); };
  forScenes("edge", [&](const StagedScene& scene) {
    EXPECT_LE(fromSide(ballOf(scene)), 28.0);
    EXPECT_GE(std::min(ballOf(scene).y, field().length - ballOf(scene).y), 110.0);
  });
  forScenes("corner", [&](const StagedScene& scene) {
    EXPECT_LE(fromSide(ballOf(scene)), 40.0);
    EXPECT_GE(ballOf(scene).y, field().length - 40.0);
  });
}

TEST(Scenes, BeforeAGoalieRedHasTheBallBetweenItselfAndTheGoal) {
  for (const char* kind : {"goalie-one", "goalie-two"})
    forScenes(kind, [](const StagedScene& scene) {
      EXPECT_LT(placeOf(scene, TeamColour::red, 2).position.y, ballOf(scene).y + 35.0);
      EXPECT_LE(apart(scene, TeamColour::red, 2), 70.0);
      EXPECT_EQ(scene.robots[2], '1');
    });
}

TEST(Scenes, AnOpponentStandsBetweenRedAndTheBallBehindIt) {
  forScenes("behind", [](const StagedScene& scene) {
    EXPECT_LT(apart(scene, TeamColour::blue, 2), 46.0);
    EXPECT_GT(apart(scene, TeamColour::red, 2), apart(scene, TeamColour::blue, 2));
  });
}

// By the seed in turn: where 2005's ball was, as a share of the field.
TEST(Scenes, InARivalAttackBlueRunsAtRedsGoalFromOneOfSixPlaces) {
  forScenes("rival-attack", [](const StagedScene& scene) {
    EXPECT_EQ(scene.robots, "4v4");
    EXPECT_GT(ballOf(scene).y, 0.39 * field().length);
    EXPECT_LT(ballOf(scene).y, 0.60 * field().length);
    EXPECT_LE(scene.staging.ball->velocity.y, 19.0);
    double nearest = 1e9;
    for (const int number : {2, 3, 4})
      nearest = std::min(nearest, apart(scene, TeamColour::blue, number));
    EXPECT_LT(nearest, 130.0);
  });
}

TEST(Scenes, ARivalAttackComesFromEitherSideWithItsBallRollingAsItDid) {
  int left = 0;
  for (std::uint64_t turn = 0; turn < 50; ++turn) {
    const Ball ball = *drawn("rival-attack", 6 * turn).staging.ball;
    const double outward = ball.position.x - 0.5 * field().width;
    left += outward < 0.0;
    EXPECT_NEAR(std::fabs(outward), (277.0 - 181.5) * field().width / 363.0, 0.01);
    EXPECT_EQ(ball.velocity.x, outward < 0.0 ? 24.0 : -24.0);
    EXPECT_EQ(ball.velocity.y, 18.0);
  }
  EXPECT_GT(left, 12);
  EXPECT_LT(left, 38);
}

TEST(Scenes, WhoServedAPenaltyInARivalAttackStandsByACornerOfItsOwnHalf) {
  for (std::uint64_t turn = 0; turn < 50; ++turn) {
    const Point2<Field> four =
        placeOf(drawn("rival-attack", 6 * turn), TeamColour::blue, 4).position;
    EXPECT_LT(std::min(four.x, field().width - four.x), 71.0);
    EXPECT_GT(four.y, field().length - 81.0);
  }
}

TEST(Scenes, OneThatDoesNotExistNamesThoseThatDo) {
  const auto scene = drawScene("party", field(), 1);
  ASSERT_FALSE(scene);
  EXPECT_NE(scene.error().find("free-ball, contested"), std::string::npos);
}

}  // namespace
}  // namespace kelpie::sim
