// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "actuator/Gait.h"
#include "tests/actuator/Walker.h"

namespace kelpie::actuator {
namespace {

constexpr double kTick = 0.008;
constexpr double kDown = 1e-6;  // cm; lower than that a foot stands

const std::array<WalkRequest, 8> kWalks = {{{35, 0, 0},
                                            {-25, 0, 0},
                                            {0, 18, 0},
                                            {0, -18, 0},
                                            {0, 0, 2.5},
                                            {0, 0, -2.5},
                                            {25, 10, 1},
                                            {42, 20, 3.8}}};

bool down(const Point3<Robot>& foot) { return std::fabs(foot.z) < kDown; }

// Where a point that stays on the ground is one tick later in the frame of a walking robot.
Point2<Robot> fixedPointAfterTick(const Point3<Robot>& p, const Velocity& v) {
  const double x = p.x + v.left * kTick;
  const double y = p.y - v.forward * kTick;
  const double turn = v.turn * kTick;
  return {x * std::cos(turn) + y * std::sin(turn), y * std::cos(turn) - x * std::sin(turn)};
}

TEST(Gait, FeetOnTheGroundStayWhereTheyAreOnTheGround) {
  for (const WalkRequest& walk : kWalks) {
    Walker w;
    w.standUp();
    w.run(walk, 60);
    const Velocity v = w.state.gait.velocity;
    w.ticks.clear();
    w.run(walk, 22);
    for (std::size_t t = 1; t < w.ticks.size(); ++t) {
      for (const LegId leg : kLegs) {
        const auto before = w.foot(w.ticks[t - 1], leg);
        const auto after = w.foot(w.ticks[t], leg);
        if (!down(before) || !down(after)) continue;
        const auto still = fixedPointAfterTick(before, v);
        ASSERT_LT(std::hypot(after.x - still.x, after.y - still.y), 0.001);
      }
    }
  }
}

TEST(Gait, ADiagonalPairAlwaysCarriesTheBodyAtItsHeight) {
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
      ASSERT_NEAR(body::stanceFromLegs(joints).shoulderHeight, w.params.stance.shoulderHeight,
                  0.02);
    }
  }
}

// A foot lower than 0.4 cm may still touch: it must hardly slide over the ground there.
TEST(Gait, FeetThatLiftOrLandHardlySlide) {
  Walker w;
  w.standUp();
  w.run(WalkRequest{30, 0, 0}, 60);
  w.ticks.clear();
  w.run(WalkRequest{30, 0, 0}, 22);
  double slid = 0.0;
  for (std::size_t t = 1; t < w.ticks.size(); ++t) {
    const auto before = w.foot(w.ticks[t - 1], LegId::leftFront);
    const auto after = w.foot(w.ticks[t], LegId::leftFront);
    if (before.z < 0.4 && after.z < 0.4) slid += after.y - (before.y - 30 * kTick);
  }
  const double walked = 30 * kTick * static_cast<double>(w.ticks.size());
  EXPECT_LT(slid, 0.02 * walked);
}

TEST(Gait, FeetInTheAirAreLifted) {
  Walker w;
  w.standUp();
  w.run(WalkRequest{20, 0, 0}, 60);
  for (const LegId leg : kLegs) {
    double highest = 0.0;
    for (const JointAngles& joints : w.ticks) highest = std::fmax(highest, w.foot(joints, leg).z);
    EXPECT_NEAR(highest, 1.3, 0.02);
  }
}

TEST(Gait, RequestsUpToTheStepLengthAreWalkedWhole) {
  for (const WalkRequest& walk : {WalkRequest{32, 0, 0}, {-25, 0, 0}, {0, 18, 0}, {0, 0, 1.9}}) {
    Walker w;
    w.standUp();
    w.run(walk, 60);
    EXPECT_NEAR(w.state.gait.velocity.forward, walk.forward, 1e-9);
    EXPECT_NEAR(w.state.gait.velocity.left, walk.left, 1e-9);
    EXPECT_NEAR(w.state.gait.velocity.turn, walk.turn, 1e-9);
  }
}

TEST(Gait, TooMuchOfEverythingKeepsItsDirection) {
  Walker w;
  w.standUp();
  w.run(WalkRequest{42, 20, 3.8}, 60);
  const Velocity v = w.state.gait.velocity;
  EXPECT_LT(v.forward, 30.0);
  EXPECT_NEAR(v.left / v.forward, 20.0 / 42.0, 1e-9);
  EXPECT_NEAR(v.turn / v.forward, 3.8 / 42.0, 1e-9);
}

TEST(Gait, SpeedGrowsNoFasterThanTheAccelerationAllows) {
  const ActuatorParams params;
  Velocity v;
  for (int i = 0; i < 200; ++i) {
    const Velocity next = slewed(v, {i < 100 ? 35.0 : -25.0, 0, 0}, params);
    ASSERT_LE(std::fabs(next.forward - v.forward), params.gait.acceleration * kTick + 1e-12);
    v = next;
  }
  EXPECT_NEAR(v.forward, -25.0, 1e-9);
}

TEST(Gait, MirroredRequestGivesMirroredFeetHalfAStepLater) {
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

TEST(Gait, AfterTheWalkTheFeetComeHomeAndStay) {
  Walker w;
  w.standUp();
  w.run(WalkRequest{20, 5, 1}, 40);
  w.run(WalkRequest{}, 60);
  w.ticks.clear();
  w.run(WalkRequest{}, 40);
  for (const LegId leg : kLegs) {
    const auto foot = w.foot(w.ticks.back(), leg);
    const auto home = footHome(leg, w.params.stance);
    EXPECT_LT(std::hypot(foot.x - home.x, foot.y - home.y), 0.2);
    EXPECT_NEAR(foot.z, 0.0, kDown);
  }
  for (const JointAngles& joints : w.ticks) ASSERT_EQ(joints.angle, w.ticks.front().angle);
}

TEST(Gait, SwingLongerThanTheHalfStepStillLeavesAPairDown) {
  ActuatorParams params;
  params.gait.swingTicks = 60;
  Walker w(params);
  w.standUp();
  w.run(WalkRequest{10, 0, 0}, 60);
  for (const JointAngles& joints : w.ticks)
    ASSERT_NEAR(body::stanceFromLegs(joints).shoulderHeight, w.params.stance.shoulderHeight, 0.02);
}

}  // namespace
}  // namespace kelpie::actuator
