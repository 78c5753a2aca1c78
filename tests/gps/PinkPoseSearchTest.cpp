// SPDX-License-Identifier: Apache-2.0
// A robot carried to an unknown place finds it by field lines and mapped pink patches.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gps/pinks/PinkPoseSearch.h"
#include "gps/pinks/Survey.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegree = maths::kPi / 180.0;

// Patches on the wall at these places, seen by a head that pans while the body turns at times.
class CarriedRobot : public sim::LocalisingRobot {
 public:
  CarriedRobot(sim::TruePose start, std::uint64_t seed)
      : sim::LocalisingRobot(start, seed), random_(seed + 9) {
    for (const Point2<Field> place : {Point2<Field>{-35, 100}, {395, 330}, {60, 585}, {-35, 480}})
      state.pinks.map.push_back({place, 20.0});
    input.lastCommand.pinks = PinkUse::localise;
  }

  void seePinks(double pan) {
    percepts.pinkPatches.clear();
    for (const PinkLandmark& pink : state.pinks.map) {
      const double direction =
          std::atan2(pink.position.y - truth.y, pink.position.x - truth.x) - truth.heading;
      if (Angle::rad(direction - pan).abs().deg() > 28.0) continue;
      PinkPercept patch;
      patch.distance = std::hypot(pink.position.y - truth.y, pink.position.x - truth.x);
      patch.heading = Angle::rad(direction + random_.gaussian(0.0, 0.7 * kDegree));
      patch.headingVariance = maths::square(0.7 * kDegree);
      percepts.pinkPatches.push_back(patch);
    }
  }

  // Pans for 150 frames, then turns for 60, and again.
  WorldModel lookRound(int frames, bool pinks = true) {
    WorldModel world;
    for (int i = 0; i < frames; ++i) {
      walk(0.0, 0.0, i % 210 < 150 ? 0.0 : 0.035);
      const double pan = 1.5 * std::sin(2.0 * maths::kPi * i / 75.0);
      lookAtLines(pan);
      if (pinks) seePinks(pan);
      world = step();
    }
    return world;
  }

 private:
  Random random_;
};

TEST(PinkPoseSearch, FindsTheRobotWhereverItWasPut) {
  Random random(77);
  int found = 0;
  for (std::uint64_t run = 0; run < 10; ++run) {
    const sim::TruePose start{random.uniform(40, 320), random.uniform(40, 500),
                              random.uniform(-3.1, 3.1)};
    CarriedRobot robot(start, run);
    const WorldModel world = robot.lookRound(600);
    found += robot.error(world) < 15.0 && robot.headingError(world) < 5.0 ? 1 : 0;
  }
  EXPECT_GE(found, 9);
}

TEST(PinkPoseSearch, WithoutPinksItDoesNotGuessBetweenTwins) {
  CarriedRobot robot({100, 150, 1.0}, 3);
  const WorldModel world = robot.lookRound(600, false);
  EXPECT_TRUE(robot.state.pose.lost);
  EXPECT_GT(world.positionSd, 100.0);
}

// Half a turn of the field puts each of these patches where another is.
TEST(PinkPoseSearch, TwinsThatNothingTellsApartAreNeverGuessedAndTheSurveyIsRenewed) {
  CarriedRobot robot({100, 150, 1.0}, 3);
  robot.state.pinks.map.clear();
  for (const Point2<Field> place : {Point2<Field>{-35, 100}, {395, 440}, {60, 585}, {300, -45}})
    robot.state.pinks.map.push_back({place, 20.0});
  const PinkPoseSearchParams& p = robot.params.pinks.search;
  double oldest = 0.0;
  for (int i = 0; i < 7; ++i) {
    robot.lookRound(210);
    oldest = std::max(oldest, robot.state.pinks.survey.seconds);
  }
  EXPECT_TRUE(robot.state.pose.lost);
  EXPECT_LT(oldest, p.keepSeconds + p.againSeconds + 5.0);  // a search takes a second or two
}

TEST(PinkPoseSearch, AfterManySearchesALikelyPoseIsEnough) {
  CarriedRobot robot({100, 150, 1.0}, 3);
  robot.params.pinks.search.sureShare = 1.1;  // never
  robot.params.pinks.search.patience = 1000;
  robot.lookRound(420);
  EXPECT_TRUE(robot.state.pose.lost);
  robot.params.pinks.search.patience = 2;
  const WorldModel world = robot.lookRound(420);
  EXPECT_FALSE(robot.state.pose.lost);
  EXPECT_LT(robot.error(world), 30.0);
}

TEST(PinkPoseSearch, BeginsAgainWhenPlayDoes) {
  CarriedRobot robot({100, 150, 1.0}, 3);
  robot.lookRound(600);
  EXPECT_FALSE(robot.state.pose.lost);
  robot.input.game.state = PlayState::set;
  robot.step();
  EXPECT_TRUE(robot.state.pose.lost);
  EXPECT_TRUE(robot.state.pinks.survey.points.empty());
}

TEST(PinkPoseSearch, LandmarksDoNotCountWhileLocalisingByPinks) {
  CarriedRobot robot({180, 200, 1.5}, 3);
  for (int i = 0; i < 20; ++i) {
    robot.lookAround(0.0);
    robot.step();
  }
  EXPECT_TRUE(robot.state.pose.lost);
  EXPECT_EQ(robot.state.counts.updates, 0U);
}

TEST(Survey, CarriesWhatItSawThroughATurnOnTheSpot) {
  Survey survey;
  PinkBearings bearings;
  bearings.push_back({{}, 20.0, Angle::deg(30), Angle(), 1e-4, 100.0});
  FixedVector<LinePoint, 256> points;
  points.push_back({LinePointKind::line, {0.0, 100.0}, 1.0, {}});
  addToSurvey(points, bearings, {}, survey);
  moveSurvey({0, 0, Angle::deg(90), {}}, 1.0, survey);
  bearings[0].heading = Angle::deg(-60);
  points[0].position = {100.0, 0.0};  // the same place after a quarter turn left
  addToSurvey(points, bearings, {}, survey);
  ASSERT_EQ(survey.bearings.size(), 1U);
  EXPECT_NEAR(survey.bearings[0].heading.deg(), 30.0, 1e-9);
  EXPECT_EQ(survey.bearings[0].weight, 2.0);
  EXPECT_EQ(survey.points.size(), 1U);
  EXPECT_NEAR(poseNow(survey, {{180, 270}, Angle::deg(10)}).heading.deg(), 100.0, 1e-9);
}

TEST(Survey, BrokenLinePointsAreLeftOut) {
  Survey survey;
  FixedVector<LinePoint, 256> points;
  points.push_back({LinePointKind::line, {kNan, 100.0}, 1.0, {}});
  addToSurvey(points, {}, {}, survey);
  EXPECT_TRUE(survey.points.empty());
}

TEST(PinkPoseSearch, HostileFramesLeaveAFinitePose) {
  CarriedRobot robot({180, 200, 1.5}, 3);
  robot.params.pinks.search.surveySeconds = 0.1;
  robot.params.pinks.search.minBearings = 0;
  robot.state.pinks.map.clear();
  PinkPercept broken;
  broken.heading = Angle::rad(kNan);
  broken.elevation = Angle::rad(kNan);
  for (int i = 0; i < 200; ++i) {
    robot.percepts.pinkPatches.clear();
    robot.percepts.pinkPatches.push_back(broken);
    robot.input.lastCommand.pinks = i % 3 == 0 ? PinkUse::map : PinkUse::localise;
    const WorldModel world = robot.step();
    ASSERT_TRUE(std::isfinite(world.pose.position.x) && std::isfinite(world.positionSd));
  }
}

}  // namespace
}  // namespace kelpie::gps
