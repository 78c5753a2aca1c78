// SPDX-License-Identifier: Apache-2.0
// Which side the robot is reported to lie on. Rest poses are those of the physical body (physics.md
// section 6), samples of a walk those of its section 5.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "actuator/feeling/Falls.h"
#include "robot/core/Random.h"

namespace kelpie::actuator {
namespace {

using Acceleration = std::array<double, 3>;

constexpr Acceleration kStanding{-130.0, 0.0, 970.0};
constexpr Acceleration kOnLeft{0.0, -900.0, -400.0};
constexpr Acceleration kOnRight{0.0, 900.0, -400.0};
constexpr Acceleration kOnBack{510.0, 0.0, -840.0};
constexpr Acceleration kOnNose{-880.0, 0.0, 430.0};
constexpr Acceleration kSitting{880.0, 0.0, 430.0};

void feel(const Acceleration& acceleration, int messages, FallState& state) {
  MotionInput in;
  for (SensorFrame& tick : in.sensors) tick.acceleration = acceleration;
  for (int i = 0; i < messages; ++i) stepFalls(in, {}, state);
}

FallSide after(const Acceleration& acceleration, int messages) {
  FallState state;
  feel(kStanding, 50, state);
  feel(acceleration, messages, state);
  return state.fallen;
}

TEST(Falls, SideIsThatOfTheRestPoseWithinHalfASecond) {
  EXPECT_EQ(after(kOnLeft, 15), FallSide::left);
  EXPECT_EQ(after(kOnRight, 15), FallSide::right);
  EXPECT_EQ(after(kOnBack, 15), FallSide::back);
  EXPECT_EQ(after({-900.0, 0.0, 100.0}, 15), FallSide::front);
}

TEST(Falls, WhoSitsOnItsTailIsOnItsBackAndWhoStandsOnItsNoseOnItsFront) {
  EXPECT_EQ(after(kSitting, 60), FallSide::back);
  EXPECT_EQ(after(kOnNose, 60), FallSide::front);
}

TEST(Falls, NeedSomeMessagesThatAgree) {
  FallParams params;
  params.filterTicks = 1.0;
  FallState state;
  MotionInput in;
  for (SensorFrame& tick : in.sensors) tick.acceleration = kOnLeft;
  for (int i = 0; i < 4; ++i) stepFalls(in, params, state);
  EXPECT_EQ(state.fallen, FallSide::none);
  stepFalls(in, params, state);
  EXPECT_EQ(state.fallen, FallSide::left);
}

TEST(Falls, WhoHasFallenHasNotGotUpAtFiftyDegrees) {
  FallState state;
  feel(kOnLeft, 60, state);
  feel({0.0, -750.0, 630.0}, 100, state);
  EXPECT_EQ(state.fallen, FallSide::left);
  feel(kStanding, 30, state);
  EXPECT_EQ(state.fallen, FallSide::none);
  feel({0.0, -750.0, 630.0}, 100, state);
  EXPECT_EQ(state.fallen, FallSide::none);
}

TEST(Falls, TheSideIsTheNewOneWhenTheRobotRollsOver) {
  FallState state;
  feel(kOnLeft, 60, state);
  feel(kOnBack, 60, state);
  EXPECT_EQ(state.fallen, FallSide::back);
}

// Single samples of 35 cm/s: forward -400..200, left -300..300, up 170..1960, its mean the weight.
TEST(Falls, OfAWalkingRobotAreNone) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    FallState state;
    MotionInput in;
    for (int i = 0; i < 2000; ++i) {
      for (SensorFrame& tick : in.sensors)
        tick.acceleration = {
            random.uniform(-400.0, 200.0), random.uniform(-300.0, 300.0),
            random.chance(0.45) ? random.uniform(980.0, 1960.0) : random.uniform(170.0, 980.0)};
      stepFalls(in, {}, state);
      ASSERT_EQ(state.fallen, FallSide::none) << seed << ", message " << i;
    }
  }
}

TEST(Falls, SamplesThatAreNoNumbersAreLeftOut) {
  const double nan = std::nan("");
  const double inf = std::numeric_limits<double>::infinity();
  FallState state;
  feel({nan, inf, -inf}, 100, state);
  EXPECT_EQ(state.fallen, FallSide::none);
  feel(kOnBack, 60, state);
  feel({nan, nan, nan}, 100, state);
  EXPECT_EQ(state.fallen, FallSide::back);
}

TEST(Falls, InTheAirNothingChanges) {
  EXPECT_EQ(after({0.0, 0.0, 0.0}, 100), FallSide::none);
  FallState state;
  feel(kOnLeft, 60, state);
  feel({0.0, 0.0, 0.0}, 100, state);
  EXPECT_EQ(state.fallen, FallSide::left);
}

TEST(Falls, HugeSamplesAreForgottenAsSoonAsOthers) {
  FallState state;
  feel({-1e300, 1e300, -1e300}, 100, state);
  for (const double a : state.up) EXPECT_TRUE(std::isfinite(a));
  feel(kStanding, 30, state);
  EXPECT_EQ(state.fallen, FallSide::none);
}

}  // namespace
}  // namespace kelpie::actuator
