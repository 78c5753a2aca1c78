// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "actuator/odometry/OdometryTerms.h"
#include "actuator/walk/WalkSpeed.h"
#include "robot/core/Random.h"
#include "robot/core/parameters/ParameterFile.h"
#include "tools/learn/Numbers.h"
#include "tools/learn/walk/WalkFile.h"
#include "tools/learn/walk/WalkFit.h"
#include "tools/learn/walk/WalkLearner.h"

namespace kelpie::learn {
namespace {

using actuator::Velocity;

TEST(WalkFile, IsAParameterFileThatGivesTheSetBack) {
  const actuator::WalkSet& set = actuator::standardWalks().normal;
  const auto path = std::filesystem::temp_directory_path() / "kelpie_walk_test.toml";
  std::ofstream(path) << walkText(WalkKind::low, set, "a walk\nof two lines");
  actuator::ActuatorParams params;
  ParameterSet parameters;
  parameters.add("actuator", params);
  const Status read = parameters.overlay(path.string());
  std::filesystem::remove(path);
  ASSERT_TRUE(read) << read.error();
  EXPECT_NEAR(params.walks.low.gait.hindLift, set.gait.hindLift, 1e-5);
  EXPECT_NEAR(params.walks.low.stance.bodyTilt.deg(), set.stance.bodyTilt.deg(), 1e-3);
  EXPECT_NEAR(params.walks.low.odometry.left.felt.load, set.odometry.left.felt.load, 1e-5);
}

// Half of what the body does is measured by joints that are right.
TEST(WalkFit, FindsTheCurvesAndSharesThatMadeTheSamples) {
  actuator::WalkCalibration c;
  c.forward = {0.9, 0.002};
  c.back = {0.8, 0.0};
  c.left = {1.1, -0.004};
  c.turn = {1.3, 0.05};
  c.leftPerTurn = {3.0, -0.5};
  c.turnPerLeft = {-0.01, 0.0};
  c.turnPerForwardLeft = 2e-4;
  Random random(4);
  std::vector<PathSample> samples;
  for (int i = 0; i < 200; ++i) {
    const Velocity feet{random.uniform(-30, 35), random.uniform(-30, 30), random.uniform(-2, 2)};
    const Velocity joints{random.uniform(-30, 30), random.uniform(-30, 30), random.uniform(-2, 2)};
    const auto little = [&random] { return random.uniform(-0.1, 0.1); };
    const auto side = [&little] {
      return actuator::SideReach{little(), little(), little(), little(), little(), little()};
    };
    const actuator::Felt felt{little(), {side(), side()}, {little(), little(), little()}};
    Velocity real = realSpeed(feet, c);
    real = {real.forward + 0.5 * joints.forward, real.left + 0.25 * joints.left, real.turn};
    const bool leftwards = feet.turn > 0.0;
    const auto& [left, right] = felt.reach;
    real.turn += -1.5 * felt.load * feet.turn;
    real.turn += 0.8 * (leftwards ? left : right).frontRotator * feet.turn;
    real.turn += 0.4 * (leftwards ? right : left).hindKnee * feet.turn;
    real.turn -= 0.3 * felt.change.turn;
    samples.push_back({numbersOf(actuator::alongFactors(feet, felt, joints.forward)),
                       numbersOf(actuator::leftFactors(feet, felt, joints.left)),
                       numbersOf(actuator::turnFactors(feet, felt, joints.turn)), real});
  }
  const actuator::WalkOdometry fitted = fitOdometry(samples);
  EXPECT_NEAR(fitted.forward.joints, 0.5, 1e-9);
  EXPECT_NEAR(fitted.left.joints, 0.25, 1e-9);
  EXPECT_NEAR(fitted.forward.aheadBent, 0.002, 1e-9);
  EXPECT_NEAR(fitted.left.turnBent, -0.5, 1e-9);
  // Reach is held back a little.
  EXPECT_NEAR(fitted.turn.joints, 0.0, 1e-3);
  EXPECT_NEAR(fitted.turn.felt.load, -1.5, 0.01);
  EXPECT_NEAR(fitted.turn.felt.legs.frontRotator, 0.8, 0.01);
  EXPECT_NEAR(fitted.turn.otherLegs.hindKnee, 0.4, 0.01);
  EXPECT_NEAR(fitted.turn.felt.change, -0.3, 0.01);
  EXPECT_NEAR(fitted.turn.forwardLeft, 2e-4, 1e-5);
}

TEST(WalkFit, FindsTheSwayThatMadeTheSamples) {
  Random random(5);
  actuator::WalkSet set;
  set.oscillation.tilt.turnWave = {0.05, -0.02};
  set.oscillation.tilt.forward = -0.03;
  set.oscillation.roll.stepWave = {0.01, 0.02};
  set.oscillation.height.left = 0.2;
  set.oscillation.turn.stepWave = {0.03, -0.01};
  std::vector<OscillationSample> samples;
  actuator::Swing last;
  for (int i = 0; i < 400; ++i) {
    const actuator::Stride stride{
        {random.uniform(-30, 30), random.uniform(-20, 20), random.uniform(-2, 2)},
        {random.uniform(0, 1), 1.0}};
    const Stance stance = actuator::oscillating({0.0, {}, {}}, stride, set);
    OscillationSample sample;
    sample.stride = stride;
    sample.tilt = stance.bodyTilt.rad();
    sample.roll = stance.bodyRoll.rad();
    sample.height = stance.shoulderHeight;
    const actuator::Swing swing = actuator::swing(stride, set);
    sample.moved = {swing.forward - last.forward, swing.left - last.left, swing.turn - last.turn};
    if (!samples.empty()) sample.before = samples.back().stride;
    last = swing;
    samples.push_back(sample);
  }
  const actuator::WalkOscillation oscillation = fitOscillation(samples, {}, set.max);
  EXPECT_NEAR(oscillation.tilt.turnWave.cosine, 0.05, 1e-9);
  EXPECT_NEAR(oscillation.tilt.turnWave.sine, -0.02, 1e-9);
  EXPECT_NEAR(oscillation.tilt.forward, -0.03, 1e-9);
  EXPECT_NEAR(oscillation.roll.stepWave.sine, 0.02, 1e-9);
  EXPECT_NEAR(oscillation.roll.step, 0.0, 1e-9);
  EXPECT_NEAR(oscillation.height.left, 0.2, 1e-9);
  EXPECT_NEAR(oscillation.turn.stepWave.cosine, 0.03, 1e-9);
  EXPECT_NEAR(oscillation.turn.stepWave.sine, -0.01, 1e-9);
}

TEST(Gain, OfAWalkThatFallsOrDiffersBetweenModelsIsLess) {
  WalkTrial good;
  good.speed = {40.0, 32.0, 28.0, 3.4};
  good.half = {20.0, 16.0, 14.0, 1.7};
  WalkTrial slower = good;
  slower.speed[0] = slower.half[0] = 10.0;
  WalkTrial fallen = good;
  fallen.fell = true;
  const double best = gainOf({good, good}, {});
  EXPECT_NEAR(best, 4.0, 1e-9);
  EXPECT_LT(gainOf({good, slower}, {}), best - 0.5);
  EXPECT_LT(gainOf({good, fallen}, {}), best - 0.9);
}

// A model that no search has seen (docs/physical-body.md tells the figures of five).
TEST(NormalWalk, WalksInEachDirectionAndTellsHowFar) {
  const actuator::ActuatorParams params;
  PhysicalWalker walker(variedModels(654321, 1, 0.002)[0], params, 8);
  const std::array<WalkRequest, 3> ways{{{30, 0, 0}, {-20, 0, 0}, {0, 20, 0}}};
  for (const WalkRequest& way : ways) {
    Command command;
    command.walk = way;
    for (int i = 0; i < 40; ++i) walker.step(command);
    Walked real;
    Walked reported;
    for (int i = 0; i < 60; ++i) {
      real += walkOn(walker, command);
      const Odometry& odometry = walker.output().odometry;
      reported += {odometry.forward, odometry.left, odometry.turn.rad()};
    }
    const double seconds = 60 * 0.032;
    EXPECT_NEAR(real.forward / seconds, way.forward, 0.25 * std::fabs(way.forward) + 4.0);
    EXPECT_NEAR(real.left / seconds, way.left, 0.25 * std::fabs(way.left) + 4.0);
    EXPECT_NEAR(reported.forward, real.forward, 0.12 * std::fabs(real.forward) + 3.0);
    EXPECT_NEAR(reported.left, real.left, 0.12 * std::fabs(real.left) + 3.0);
  }
  EXPECT_FALSE(walker.fallen());
}

}  // namespace
}  // namespace kelpie::learn
