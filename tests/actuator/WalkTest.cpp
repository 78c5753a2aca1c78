// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "actuator/walk/WalkSpeed.h"
#include "robot/core/Random.h"
#include "tests/actuator/Walker.h"

namespace kelpie::actuator {
namespace {

constexpr double kTick = 0.008;
constexpr double kDown = 1e-6;  // cm; lower than that a foot stands

const std::array<WalkRequest, 8> kWalks = {{{30, 0, 0},
                                            {-25, 0, 0},
                                            {0, 18, 0},
                                            {0, -18, 0},
                                            {0, 0, 1.5},
                                            {0, 0, -1.5},
                                            {20, 10, 1},
                                            {42, 20, 3.8}}};

bool down(const Point3<Robot>& foot) { return std::fabs(foot.z) < kDown; }

// Where a point that stays on the ground is one tick later in the frame of a walking robot.
Point2<Robot> fixedPointAfterTick(const Point3<Robot>& p, const Velocity& v) {
  const double half = 0.5 * v.turn * kTick;
  const double x = p.x + (v.left * std::cos(half) + v.forward * std::sin(half)) * kTick;
  const double y = p.y - (v.forward * std::cos(half) - v.left * std::sin(half)) * kTick;
  const double turn = v.turn * kTick;
  return {x * std::cos(turn) + y * std::sin(turn), y * std::cos(turn) - x * std::sin(turn)};
}

TEST(Walk, FeetOnTheGroundStayWhereTheyAreOnTheGround) {
  for (const WalkRequest& walk : kWalks) {
    Walker w;
    w.standUp();
    w.run(walk, 60);
    const Velocity v = w.state.walk.feet;
    w.ticks.clear();
    w.run(walk, 22);
    for (std::size_t t = 1; t < w.ticks.size(); ++t) {
      for (const LegId leg : kLegs) {
        const auto before = w.foot(w.ticks[t - 1], leg);
        const auto after = w.foot(w.ticks[t], leg);
        if (!down(before) || !down(after)) continue;
        const auto still = fixedPointAfterTick(before, v);
        ASSERT_LT(std::hypot(after.x - still.x, after.y - still.y), 0.01);
      }
    }
  }
}

TEST(Walk, ADiagonalPairAlwaysCarriesTheBodyAtItsHeight) {
  for (const WalkRequest& walk : kWalks) {
    Walker w;
    w.standUp();
    w.run(walk, 100);
    for (const JointAngles& joints : w.ticks) {
      std::array<bool, 4> stands{};
      for (const LegId leg : kLegs) {
        const double z = w.foot(joints, leg).z;
        ASSERT_GT(z, -0.02);
        stands[index(leg)] = z < 0.02;
      }
      const bool first = stands[index(LegId::leftFront)] && stands[index(LegId::rightHind)];
      const bool second = stands[index(LegId::rightFront)] && stands[index(LegId::leftHind)];
      ASSERT_TRUE(first || second);
      // Round paws carry the body higher the more a leg leans.
      ASSERT_NEAR(body::stanceFromLegs(joints).shoulderHeight, w.stood().shoulderHeight, 0.5);
    }
  }
}

TEST(Walk, FeetInTheAirAreLifted) {
  Walker w;
  w.standUp();
  w.run(WalkRequest{15, 0, 0}, 60);
  for (const LegId leg : kLegs) {
    double highest = 0.0;
    for (const JointAngles& joints : w.ticks) highest = std::fmax(highest, w.foot(joints, leg).z);
    EXPECT_NEAR(highest, w.params.walks.normal.gait.frontLift, 0.02);
  }
}

// Whatever is asked for, and however the request changes.
TEST(Walk, NoTargetJumpsWhateverIsAskedInTurn) {
  ActuatorParams params;
  params.walkSlew = Angle::deg(20.0);  // what the clamp would hide
  Random random(5);
  Walker w(params);
  w.standUp();
  for (int i = 0; i < 60; ++i) {
    WalkRequest walk{random.uniform(-45, 60), random.uniform(-35, 35), random.uniform(-4, 4)};
    walk.kind = static_cast<WalkKind>(random.index(kWalkKindCount));
    w.run(walk, 5);
  }
  for (std::size_t t = 1; t < w.ticks.size(); ++t)
    for (const LegId leg : kLegs) {
      const auto moved = w.foot(w.ticks[t], leg) - w.foot(w.ticks[t - 1], leg);
      ASSERT_LT(std::hypot(moved.x, moved.y), 2.5);
    }
}

TEST(Walk, ThePhaseNeverGoesBack) {
  PhaseState state;
  GaitParams gait;
  double last = 0.0;
  double turned = 0.0;
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    gait.halfStepTicks = random.uniform(8, 30);
    stepPhase(random.chance(0.9), gait, state);
    const double step = state.phase - last - std::floor(state.phase - last);
    ASSERT_LE(step, 0.5 / 8 + 1e-12);
    turned += step;
    last = state.phase;
  }
  EXPECT_GT(turned, 20.0);
}

TEST(Walk, TooMuchOfEverythingKeepsItsDirection) {
  Walker w;
  w.standUp();
  w.run(WalkRequest{42, 20, 3.8}, 60);
  const Velocity v = w.state.walk.feet;
  EXPECT_LT(v.forward, 25.0);
  EXPECT_NEAR(v.left / v.forward, 20.0 / 42.0, 1e-9);
  EXPECT_NEAR(v.turn / v.forward, 3.8 / 42.0, 1e-9);
}

TEST(Walk, SpeedGrowsNoFasterThanTheAccelerationAllows) {
  const GaitParams gait;
  Velocity v;
  for (int i = 0; i < 200; ++i) {
    const Velocity next = approached(v, {i < 100 ? 35.0 : -25.0, 0, 0}, gait);
    ASSERT_LE(std::fabs(next.forward - v.forward), gait.acceleration * kTick + 1e-12);
    v = next;
  }
  EXPECT_NEAR(v.forward, -25.0, 1e-9);
}

TEST(Walk, FeetMoveSoThatTheRequestBecomesReal) {
  Random random(7);
  WalkCalibration c;
  c.forward = {0.8, 0.004};
  c.back = {0.7, 0.0};
  c.left = {0.9, -0.006};
  c.turn = {0.75, 0.02};
  c.leftPerTurn = {-4.0, 0.3};
  c.turnPerLeft = {0.01, 0.0};
  c.turnPerForwardLeft = 1e-4;
  c.leftPerForwardTurn = 0.01;
  c.forwardPerLeftTurn = -0.02;
  c.forwardPerTurn = 1.0;
  c.forwardPerLeft = -0.1;
  for (int i = 0; i < 200; ++i) {
    const Velocity real{random.uniform(-25, 35), random.uniform(-15, 15), random.uniform(-2, 2)};
    const Velocity again = realSpeed(feetSpeed(real, c), c);
    EXPECT_NEAR(again.forward, real.forward, 1e-5);
    EXPECT_NEAR(again.left, real.left, 1e-5);
    EXPECT_NEAR(again.turn, real.turn, 1e-5);
  }
}

TEST(Walk, TurningAboutAPointKeepsItInItsPlace) {
  const WalkSet set;
  const double pivot = 15.0;
  const Velocity v = wantedSpeed({0, 0, 0.5, pivot}, set);
  EXPECT_NEAR(v.left + v.turn * pivot, 0.0, 1e-9);  // of the ground below the pivot
  EXPECT_EQ(v.forward, 0.0);
}

// 1 where the feet go as far as they may.
double strokeShare(const Velocity& feet, const StrokeLimits& max) {
  return std::hypot(feet.forward / (feet.forward < 0.0 ? max.back : max.forward),
                    feet.left / max.left, feet.turn / max.turn);
}

TEST(Walk, ARequestBeyondTheFeetKeepsItsDirection) {
  const WalkSet set = standardWalks().normal;
  for (const WalkRequest& request :
       {WalkRequest{0, 0, 20}, {0, 0, -5}, {150, 150, 0}, {-90, 40, 3}, {300, 0, 2}}) {
    const Velocity feet = wantedSpeed(request, set);
    EXPECT_NEAR(strokeShare(feet, set.max), 1.0, 0.01);
    const Velocity real = realSpeed(feet, set.calibration);
    const double share = std::hypot(real.forward, real.left, real.turn) /
                         std::hypot(request.forward, request.left, request.turn);
    EXPECT_NEAR(real.forward, share * request.forward, 0.3);
    EXPECT_NEAR(real.left, share * request.left, 0.3);
    EXPECT_NEAR(real.turn, share * request.turn, 0.03);
  }
}

TEST(Walk, MirroredRequestGivesMirroredFeetHalfAStepLater) {
  Walker left;
  Walker right;
  left.standUp();
  right.standUp();
  left.run(WalkRequest{15, 10, 1}, 110);
  right.run(WalkRequest{15, -10, -1}, 110);
  const int half = 22;
  for (std::size_t t = 250; t + half < left.ticks.size(); ++t) {
    const auto l = left.foot(left.ticks[t], LegId::leftFront);
    const auto r = right.foot(right.ticks[t + half], LegId::rightFront);
    ASSERT_NEAR(l.x, -r.x, 1e-6);
    ASSERT_NEAR(l.y, r.y, 1e-6);
    ASSERT_NEAR(l.z, r.z, 1e-6);
  }
}

TEST(Walk, AfterTheWalkTheFeetComeHomeAndStay) {
  Walker w;
  w.standUp();
  w.run(WalkRequest{20, 5, 1}, 40);
  w.run(WalkRequest{}, 60);
  w.ticks.clear();
  w.run(WalkRequest{}, 40);
  for (const LegId leg : kLegs) {
    const auto foot = w.foot(w.ticks.back(), leg);
    const auto home = footHome(leg, w.stance());
    EXPECT_LT(std::hypot(foot.x - home.x, foot.y - home.y), 1e-6);
    EXPECT_NEAR(foot.z, 0.0, kDown);
  }
  for (const JointAngles& joints : w.ticks) ASSERT_EQ(joints.angle, w.ticks.front().angle);
}

TEST(Walk, AnotherSetIsTakenUpBitByBitWithSteps) {
  ActuatorParams params = exactWalks();
  params.walks.low = params.walks.normal;
  params.walks.low.stance.shoulderHeight = 8.0;
  Walker w(params);
  w.standUp();
  Command command;
  command.walk.kind = WalkKind::low;
  double last = 10.2;
  double lifted = 0.0;
  for (int i = 0; i < 60; ++i) {
    w.run(command, 1);
    const double height = w.state.walk.set.stance.shoulderHeight;
    ASSERT_LE(height, last);
    ASSERT_GT(height, last - 0.5);
    lifted = std::fmax(lifted, w.state.walk.phase.lift);
    last = height;
  }
  EXPECT_NEAR(last, 8.0, 1e-9);
  EXPECT_GT(lifted, 0.5);
  EXPECT_EQ(w.state.walk.phase.lift, 0.0);
}

// The search for the feet's speed is left out where set and request stay, and only there.
void expectKnownChangesNothing(const ActuatorParams& params) {
  Random random(12);
  WalkState known;
  WalkState anew;
  WalkRequest request{};
  for (int tick = 0; tick < 2000; ++tick) {
    if (random.chance(0.2))
      request = {random.uniform(-80, 80), random.uniform(-60, 60), random.uniform(-9, 9)};
    if (random.chance(0.02)) request.kind = random.chance(0.5) ? WalkKind::fast : WalkKind::normal;
    anew.known = false;
    stepWalk(request, params, known);
    stepWalk(request, params, anew);
    ASSERT_EQ(known.feet.forward, anew.feet.forward) << tick;
    ASSERT_EQ(known.feet.left, anew.feet.left) << tick;
    ASSERT_EQ(known.feet.turn, anew.feet.turn) << tick;
    ASSERT_EQ(known.set.stance.shoulderHeight, anew.set.stance.shoulderHeight) << tick;
  }
}

TEST(Walk, WhatIsKnownOfTheLastTickChangesNoBit) {
  ActuatorParams params = exactWalks();
  params.walks.fast.stance.shoulderHeight = 9.0;
  params.walks.fast.calibration.turn.scale = 0.8;
  expectKnownChangesNothing(params);
  params.mixSeconds = 0.0;
  expectKnownChangesNothing(params);
}

}  // namespace
}  // namespace kelpie::actuator
