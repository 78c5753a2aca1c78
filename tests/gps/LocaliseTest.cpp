// SPDX-License-Identifier: Apache-2.0
// The localiser as a whole: from an unknown start, after a kidnapping, with false and broken input.
#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "gps/Refusal.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

struct Errors {
  double cm = 0.0;
  double deg = 0.0;
};

// Mean errors over the last 60 of 120 frames of a walk with panning head, over 20 runs; the
// odometry reports that share of the way.
Errors walkErrors(double heading, double falseShare = 0.0, double reported = 1.0) {
  Errors sum;
  for (std::uint64_t run = 0; run < 20; ++run) {
    Random random(run + 100);
    sim::LocalisingRobot robot({180, 270, heading}, run);
    for (int i = 0; i < 120; ++i) {
      robot.walk(0.7, 0.0, 0.008 * std::sin(i / 20.0));
      robot.input.odometry.forward *= reported;
      robot.lookAround(sim::panAt(i));
      robot.falsify(falseShare, random);
      const WorldModel world = robot.step();
      if (i < 60) continue;
      sum.cm += robot.error(world) / 60 / 20;
      sum.deg += robot.headingError(world) / 60 / 20;
    }
  }
  std::printf("walk heading %.0f false %.2f odometry %.2f: %.2f cm %.2f deg\n",
              heading * 180 / maths::kPi, falseShare, reported, sum.cm, sum.deg);
  return sum;
}

TEST(Localise, WalkFromAnUnknownStartIsFollowedAtEveryHeading) {
  for (const double heading : {0.0, 0.5, 1.0, 1.5}) {
    const Errors errors = walkErrors(heading * maths::kPi);
    EXPECT_LT(errors.cm, 4.0) << heading;
    EXPECT_LT(errors.deg, 1.0) << heading;
  }
}

TEST(Localise, OneFalseSightingInTwentyCostsLittle) {
  EXPECT_LT(walkErrors(maths::kPi / 2, 0.05).cm, 5.0);
}

TEST(Localise, OdometryEightPercentLongOrShortCostsLittle) {
  EXPECT_LT(walkErrors(maths::kPi / 2, 0.0, 1.08).cm, 4.0);
  EXPECT_LT(walkErrors(maths::kPi / 2, 0.0, 0.92).cm, 4.0);
}

// Frames from the kidnapping until the estimate stays within 30 cm and 15 deg.
int recovery(std::uint64_t seed) {
  Random random(seed);
  sim::LocalisingRobot robot({180, 200, maths::kPi / 2}, seed);
  int last = 0;
  for (int i = 0; i < 400; ++i) {
    if (i == 100) {
      robot.truth = {random.uniform(40, 320), random.uniform(60, 480), random.uniform(0, 6.28)};
    }
    robot.walk(0.5, 0.0, 0.02);
    robot.lookAround(sim::panAt(i));
    const WorldModel world = robot.step();
    const bool good = robot.error(world) < 30.0 && robot.headingError(world) < 15.0;
    if (i >= 100 && !good) last = i - 99;
  }
  return last;
}

TEST(Localise, KidnappedRobotFindsItselfAgain) {
  std::vector<int> frames;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) frames.push_back(recovery(seed));
  std::sort(frames.begin(), frames.end());
  std::printf("kidnapped: median %d, worst %d frames\n", frames[10], frames[19]);
  EXPECT_LT(frames[10], 30);
  EXPECT_LT(frames[18], 150);
}

// Eight modes crowd round a wrong pose, so that none of the filter's wide modes lives on.
TEST(Localise, PoseTurnedRoundIsGivenUpWithOneGoalInSight) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    sim::LocalisingRobot robot({180, 230, -1.6}, seed);
    robot.lookAround(0.0);
    robot.step();
    robot.state.pose.modes.clear();
    for (int i = 0; i < 8; ++i) {
      const Pose2 wrong{{120.0 + 12.0 * i, 235.0}, Angle::deg(100.0 + 3.0 * i)};
      robot.state.pose.modes.push_back({0.125, wrong, {25, 0, 0, 0, 25, 0, 0, 0, 0.003}, {}, {}});
    }
    robot.state.pose.lost = false;
    WorldModel world;
    for (int i = 0; i < 90; ++i) {
      robot.lookAround(0.0);
      world = robot.step();
    }
    EXPECT_LT(robot.headingError(world), 90.0) << seed;  // one landmark leaves a circle of places
  }
}

TEST(Localise, KnownStartIsKeptWhileNothingIsSeen) {
  sim::LocalisingRobot robot({60, 100, 0.4});
  robot.params.initialPose = {true, {{60, 100}, Angle::rad(0.4)}, 5.0, Angle::deg(3)};
  WorldModel world;
  for (int i = 0; i < 90; ++i) {
    robot.walk(0.7, 0.2, 0.01);
    world = robot.step();
  }
  EXPECT_LT(robot.error(world), 0.1);
  EXPECT_LT(robot.headingError(world), 0.01);
  EXPECT_NEAR(world.secondsSinceLandmark, 3.0, 1e-9);
}

TEST(Localise, WeightsSumToOneAndAreSorted) {
  sim::LocalisingRobot robot({100, 300, 2.0}, 5);
  for (int i = 0; i < 200; ++i) {
    robot.walk(0.5, 0.0, 0.01);
    robot.lookAround(sim::panAt(i));
    const WorldModel world = robot.step();
    double sum = 0.0, previous = 1.0;
    for (const PoseMode& mode : world.modes) {
      EXPECT_LE(mode.weight, previous);
      sum += previous = mode.weight;
    }
    ASSERT_NEAR(sum, 1.0, 1e-9);
  }
}

// The mirrored robot: left and right swapped, beacons swapped, same noise.
TEST(Localise, MirroredSightingsGiveTheMirroredPose) {
  sim::LocalisingRobot left({100, 250, 1.9}), right({260, 250, maths::kPi - 1.9});
  const auto map = body::landmarksFor(left.params.field, TeamColour::red);
  const auto& mirrored = map;
  for (int i = 0; i < 30; ++i) {
    left.percepts.landmarks.clear();
    right.percepts.landmarks.clear();
    for (std::size_t k = 0; k < map.size(); ++k) {
      for (std::size_t j = 0; j < map.size(); ++j) {
        const bool twin = std::fabs(map[k].position.x + mirrored[j].position.x - 360) < 1e-9 &&
                          map[k].position.y == mirrored[j].position.y;
        if (!twin) continue;
        left.percepts.landmarks.push_back(left.look(map[k], false));
        right.percepts.landmarks.push_back(right.look(mirrored[j], false));
      }
    }
    const Pose2 a = left.step().pose, b = right.step().pose;
    ASSERT_NEAR(a.position.x, 360.0 - b.position.x, 1e-6);
    ASSERT_NEAR(a.position.y, b.position.y, 1e-6);
    ASSERT_NEAR((a.heading + b.heading - Angle::rad(maths::kPi)).rad(), 0.0, 1e-9);
  }
}

TEST(Localise, BlueTeamSeesTheFieldTurnedRound) {
  sim::LocalisingRobot robot({180, 200, maths::kPi / 2});
  robot.input.game.team = TeamColour::blue;
  WorldModel world;
  for (int i = 0; i < 120; ++i) {
    robot.lookAround(sim::panAt(i));
    world = robot.step();
  }
  EXPECT_LT(robot.error(world), 15.0);
}

// Frames of three seconds of a walk with lines and the first landmark that came into view, in which
// the robot thinks that it is within 15 cm and is not within 100.
int sureAndWrong(std::uint64_t seed) {
  Random random(seed);
  sim::LocalisingRobot robot(
      {random.uniform(60.0, 300.0), random.uniform(60.0, 480.0), random.uniform(-3.0, 3.0)}, seed);
  std::optional<LandmarkKind> only;
  int frames = 0;
  for (int i = 0; i < 90; ++i) {
    robot.walk(0.7, 0.0, 0.01);
    robot.lookAround(sim::panAt(i));
    robot.lookAtLines(sim::panAt(i));
    auto& seen = robot.percepts.landmarks;
    if (!only && !seen.empty()) only = seen[0].kind;
    const auto kept = seen;
    seen.clear();
    for (const LandmarkPercept& p : kept)
      if (p.kind == *only) seen.push_back(p);
    const WorldModel world = robot.step();
    frames += world.positionSd < 15.0 && robot.error(world) > 100.0 ? 1 : 0;
  }
  return frames;
}

TEST(Localise, ARobotThatHasSeenOneLandmarkIsNeverSureOfAPlaceFarFromItsOwn) {
  int frames = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) frames += sureAndWrong(seed);
  EXPECT_EQ(frames, 0);
}

TEST(Localise, BrokenInputLeavesAFiniteWideEstimateAndIsCounted) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  sim::LocalisingRobot robot({180, 200, 1.0});
  robot.input.odometry.forward = 1000.0;
  for (const double bad : {kNan, kInf, -kInf, -1.0, 0.0}) {
    LandmarkPercept p = robot.look({LandmarkKind::goalBlue, {180, 540}});
    p.distance = bad;
    robot.percepts.landmarks.push_back(p);
  }
  LandmarkPercept p = robot.look({LandmarkKind::goalBlue, {180, 540}});
  p.headingVariance = kInf;
  robot.percepts.landmarks.push_back(p);
  robot.percepts.ball = {true, kNan, {}, {}, 1.0, 1.0, {}, {}, 0.0};
  const WorldModel world = robot.step();
  EXPECT_TRUE(std::isfinite(world.pose.position.x));
  EXPECT_GT(world.positionSd, 100.0);
  EXPECT_FALSE(world.ball.present);
  const auto count = [&](Refusal r) { return world.counts.refused[static_cast<std::size_t>(r)]; };
  EXPECT_EQ(count(Refusal::landmarkNotFinite), 6);
  EXPECT_EQ(count(Refusal::odometryNotFinite), 1);
  EXPECT_EQ(count(Refusal::ballNotFinite), 1);
}

}  // namespace
}  // namespace kelpie::gps
