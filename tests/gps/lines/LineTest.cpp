// SPDX-License-Identifier: Apache-2.0
// Field lines: distances, the match and its maximum, and the update by it.
#include <gtest/gtest.h>

#include <limits>

#include "gps/Refusal.h"
#include "gps/lines/LineUpdate.h"
#include "gps/pose/Modes.h"
#include "tests/gps/Field2006.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::gps {
namespace {

TEST(FieldFeatures, DistanceIsThatToTheNearestPaint) {
  EXPECT_NEAR(std::fabs(features().nearest({60.0, 280.0}).value), 10.0, 1e-9);  // halfway line
  EXPECT_NEAR(std::fabs(features().nearest({180.0, 270.0 + 30.0}).value), 30.0 - 16.75, 1e-9);
  EXPECT_NEAR(features().outside({-30.0, 300.0}).value, 10.0, 1e-9);
  EXPECT_EQ(features().outside({10.0, 300.0}).value, 0.0);
}

TEST(FieldFeatures, SlopeIsThatOfTheDistance) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Point2<Field> p{random.uniform(-80, 440), random.uniform(-80, 620)};
    const FeatureDistance d = features().nearest(p);
    const double h = 1e-4;
    const double dx = (features().nearest({p.x + h, p.y}).value - d.value) / h;
    const double dy = (features().nearest({p.x, p.y + h}).value - d.value) / h;
    EXPECT_NEAR(dx, d.alongX, 1e-2);
    EXPECT_NEAR(dy, d.alongY, 1e-2);
  }
}

TEST(LineFit, MatchIsWholeAtTheTruePoseAndAtItsTwin) {
  const SeenLines seen = seenFrom(kPose);
  const LineUpdateParams p;
  EXPECT_GT(lineMatch(seen, kPose, features(), p), 0.99);
  const Pose2 twin{{360.0 - 150.0, 540.0 - 120.0}, Angle::deg(220.0)};
  EXPECT_NEAR(lineMatch(seen, twin, features(), p), lineMatch(seen, kPose, features(), p), 1e-6);
  const Pose2 lateral{{170.0, 105.0}, Angle::deg(40.0)};
  EXPECT_LT(lineMatch(seen, lateral, features(), p), 0.7);
}

TEST(LineFit, FindsThePoseFromNearBy) {
  const SeenLines seen = seenFrom(kPose);
  const Pose2 start{{160.0, 110.0}, Angle::deg(47.0)};
  const LineFit fit = fitLines(seen, start, features(), {});
  EXPECT_LT(distance(fit.pose.position, kPose.position), 0.5);
  EXPECT_LT((fit.pose.heading - kPose.heading).abs().deg(), 0.3);
  EXPECT_LE(fit.steps, LineUpdateParams{}.maxSteps);
}

TEST(LineFit, AStraightLineSaysNothingAlongIt) {
  SeenLines seen;  // the side line x = 0, seen from 60 cm, facing it
  for (double y = -40; y <= 40; y += 10) seen.lines.push_back({{y, 60.0}, 1.0});
  const Pose2 pose{{61.25, 200.0}, Angle::deg(180.0)};
  const LineFit fit = fitLines(seen, pose, features(), {});
  EXPECT_GT(fit.information(0, 0), 0.05);
  EXPECT_NEAR(fit.information(1, 1), 0.0, 1e-9);
  EXPECT_NEAR(fit.pose.position.y, 200.0, 1e-6);
}

TEST(LineFit, BrokenPointsAreLeftOut) {
  FixedVector<LinePoint, 256> points;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  points.push_back({LinePointKind::line, {nan, 1.0}, 1.0, {}});
  points.push_back({LinePointKind::line, {1.0, 2.0}, std::numeric_limits<double>::infinity(), {}});
  points.push_back({LinePointKind::line, {1.0, 2.0}, -1.0, {}});
  points.push_back({LinePointKind::line, {1.0, 2.0}, 0.5, {}});
  EXPECT_EQ(seenLines(points, {}).lines.size(), 1U);
}

TEST(LineObservation, PoorMatchesAreRefusedAndFastHeadsBelievedLess) {
  LineFit fit = fitLines(seenFrom(kPose), kPose, features(), {});
  const auto still = observationOf(fit, features(), 0.0, {});
  const auto fast = observationOf(fit, features(), 0.08, {});
  ASSERT_TRUE(still && fast);
  EXPECT_GT(still->information(0, 0), 2.0 * fast->information(0, 0));
  fit.match = 0.79;  // 0.8 with a still head
  EXPECT_FALSE(observationOf(fit, features(), 0.0, {}));
  EXPECT_TRUE(observationOf(fit, features(), 0.08, {}));
  fit.match = 1.0;
  fit.pose.position = {-40.0, 100.0};
  EXPECT_FALSE(observationOf(fit, features(), 0.0, {}));
}

// Of the copy that the lines did not correct, beside the mode as it was.
double weightOfCopy(double shaking) {
  SeenLines seen = seenFrom(kPose);
  seen.shaking = shaking;
  Modes modes;
  PoseMode mode;
  mode.weight = 1.0;
  mode.pose = kPose;
  mode.covariance = {9, 0, 0, 0, 9, 0, 0, 0, 0.002};
  mode.tilt = {Angle{}, Angle{}, 1e-6, 1e-6};
  modes.push_back(mode);
  GpsCounts counts;
  static_cast<void>(updateByLines(seen, features(), {}, modes, counts));
  return modes.back().weight;
}

TEST(LineObservation, LinesOfAShakenBodyAreDoubtedMore) {
  const LineUpdateParams p;
  EXPECT_NEAR(weightOfCopy(0.0), p.outlierWeight, 1e-9);
  EXPECT_NEAR(weightOfCopy(0.5), 0.5 * (p.outlierWeight + p.shakenOutlierWeight), 1e-9);
  EXPECT_NEAR(weightOfCopy(7.0), p.shakenOutlierWeight, 1e-9);
}

TEST(LineObservation, AWorseMatchWeighsLess) {
  LineFit fit = fitLines(seenFrom(kPose), kPose, features(), {});
  const auto factor = [&](double match) {
    fit.match = match;
    return observationOf(fit, features(), 0.0, {})->matchFactor;
  };
  const LineUpdateParams params;
  EXPECT_NEAR(factor(1.0), 1.0, 1e-3);
  EXPECT_NEAR(factor(0.9), std::sqrt(params.refusedWeight), 1e-2);
  EXPECT_NEAR(factor(0.801), params.refusedWeight, 1e-2);
}

double meanErrorByLines(LineUse use, Angle tiltSd) {
  double sum = 0.0;
  for (std::uint64_t run = 0; run < 40; ++run) {
    sim::LocalisingRobot robot({180, 250, 1.0}, run);
    robot.params.lines.update.use = use;
    robot.params.tilt.use = true;
    robot.params.tilt.initialSd = tiltSd;
    robot.params.initialPose = {true, {{195, 240}, Angle::rad(1.1)}, 20.0, Angle::deg(10)};
    for (int i = 0; i < 90; ++i) {
      robot.walk(0.7, 0.0, 0.01);
      robot.lookAtLines(1.2 * std::sin(i / 10.0));
      const WorldModel world = robot.step();
      if (i >= 60) sum += robot.error(world) / 30 / 40;
    }
  }
  return sum;
}

TEST(Lines, AloneKeepAKnownPose) {
  const Angle known = Angle::deg(0.3);
  EXPECT_LT(meanErrorByLines(LineUse::position, known), 4.0);
  EXPECT_GT(meanErrorByLines(LineUse::off, known), 12.0);
}

TEST(Lines, AloneTellThePoseMoreSlowlyWhileTheTiltIsUnknown) {
  const double unknown = meanErrorByLines(LineUse::position, Angle::deg(1.5));
  EXPECT_GT(unknown, meanErrorByLines(LineUse::position, Angle::deg(0.3)));
  EXPECT_LT(unknown, 9.0);
}

// Before the own goal, which it looks at; believes to stand 3 cm to the side and 3 cm nearer.
sim::LocalisingRobot seeingLines(LineUse use) {
  sim::LocalisingRobot robot({180, 130, -1.4});
  robot.params.lines.update.use = use;
  robot.believe({{183, 127}, Angle::rad(-1.38)}, 10.0, Angle::deg(5));
  robot.step();
  robot.lookAtLines(0.0);
  return robot;
}

TEST(Lines, OffTheyLeaveTheModesAsTheyAre) {
  sim::LocalisingRobot robot = seeingLines(LineUse::off);
  robot.state.pose.modes.push_back(robot.state.pose.modes[0]);
  robot.state.pose.modes[1].pose = {{250, 400}, Angle::deg(20)};
  const Modes before = robot.state.pose.modes;
  robot.step();
  ASSERT_EQ(robot.state.pose.modes.size(), 2U);
  EXPECT_EQ(robot.state.pose.modes[0].pose.position.x, before[0].pose.position.x);
  EXPECT_EQ(robot.state.pose.modes[0].weight, robot.state.pose.modes[1].weight);
}

TEST(Lines, ThatOnlyJudgeWeighTheModesAndMoveNone) {
  sim::LocalisingRobot robot = seeingLines(LineUse::sanity);
  const double variance = robot.state.pose.modes[0].covariance[0];
  robot.state.pose.modes.push_back(robot.state.pose.modes[0]);
  robot.state.pose.modes[1].pose.position = {180, 200};  // no lines are so
  for (int frame = 0; frame < 5; ++frame) robot.step();
  const Modes& modes = robot.state.pose.modes;
  ASSERT_EQ(modes.size(), 2U);
  EXPECT_EQ(modes[0].pose.position.x, 183.0);
  EXPECT_EQ(modes[0].pose.position.y, 127.0);
  EXPECT_EQ(modes[1].pose.position.y, 200.0);
  EXPECT_GE(modes[0].covariance[0], variance);
  EXPECT_GT(modes[0].weight, 5.0 * modes[1].weight);
}

TEST(Lines, ThatCorrectMoveTheMode) {
  sim::LocalisingRobot robot = seeingLines(LineUse::position);
  const double before = std::hypot(3.0, 3.0);
  WorldModel world;
  for (int frame = 0; frame < 5; ++frame) world = robot.step();
  EXPECT_NE(robot.state.pose.modes[0].pose.position.x, 183.0);
  EXPECT_LT(robot.error(world), before);
}

TEST(Lines, OfNonsenseLeaveAFiniteWideEstimate) {
  sim::LocalisingRobot robot({180, 250, 1.0});
  robot.params.initialPose = {true, {{180, 250}, Angle::rad(1.0)}, 20.0, Angle::deg(10)};
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    robot.percepts.linePoints.clear();
    for (int k = 0; k < 60; ++k)
      robot.percepts.linePoints.push_back(
          {LinePointKind::line, {random.uniform(-1e6, 1e6), random.uniform(-1e3, 1e3)}, 1.0, {}});
    const WorldModel world = robot.step();
    ASSERT_TRUE(std::isfinite(world.pose.position.x) && std::isfinite(world.positionSd));
  }
  EXPECT_GT(robot.state.counts.refused[static_cast<std::size_t>(Refusal::linesMatchNothing)], 0);
  EXPECT_LT(robot.error(robot.step()), 5.0);
}

}  // namespace
}  // namespace kelpie::gps
