// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "actuator/odometry/BodyOscillation.h"
#include "robot/core/Random.h"
#include "tests/actuator/Walker.h"

namespace kelpie::actuator {
namespace {

// Every number of a curve another.
OscillationCurve anyCurve(Random& random) {
  const auto next = [&] { return random.uniform(-0.1, 0.1); };
  return {next(),           next(),           next(),           next(),
          {next(), next()}, {next(), next()}, {next(), next()}, {next(), next()},
          {next(), next()}, {next(), next()}, {next(), next()}, {next(), next()}};
}

WalkSet anySet(Random& random) {
  WalkSet set;
  for (OscillationCurve WalkOscillation::*curve :
       {&WalkOscillation::tilt, &WalkOscillation::roll, &WalkOscillation::height,
        &WalkOscillation::forward, &WalkOscillation::left, &WalkOscillation::turn})
    set.oscillation.*curve = anyCurve(random);
  return set;
}

Stride anyStride(Random& random) {
  return {{random.uniform(-30, 30), random.uniform(-20, 20), random.uniform(-2, 2)},
          {random.uniform(0, 1), random.uniform(0.1, 1)}};
}

TEST(BodyOscillation, AStandingRobotHasNone) {
  Random random(1);
  Stride stride = anyStride(random);
  stride.phase.lift = 0.0;
  const Stance legs{10.0, Angle::deg(7), {}};
  const Stance stance = oscillating(legs, stride, anySet(random));
  EXPECT_EQ(stance.shoulderHeight, legs.shoulderHeight);
  EXPECT_EQ(stance.bodyTilt, legs.bodyTilt);
  EXPECT_EQ(stance.bodyRoll, legs.bodyRoll);
}

TEST(BodyOscillation, OfTheMirroredWalkHalfAStepLaterIsTheMirroredSway) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const WalkSet set = anySet(random);
    const Stride stride = anyStride(random);
    const Stride other{{stride.feet.forward, -stride.feet.left, -stride.feet.turn},
                       {stride.phase.phase + 0.5, stride.phase.lift}};
    const Stance one = oscillating({}, stride, set);
    const Stance two = oscillating({}, other, set);
    ASSERT_NEAR(one.bodyTilt.rad(), two.bodyTilt.rad(), 1e-12);
    ASSERT_NEAR(one.shoulderHeight, two.shoulderHeight, 1e-12);
    ASSERT_NEAR(one.bodyRoll.rad(), -two.bodyRoll.rad(), 1e-12);
    const Swing here = swing(stride, set);
    const Swing there = swing(other, set);
    ASSERT_NEAR(here.forward, there.forward, 1e-12);
    ASSERT_NEAR(here.left, -there.left, 1e-12);
    ASSERT_NEAR(here.turn, -there.turn, 1e-12);
  }
}

TEST(BodyOscillation, IsInTheStancesOfAWalkingBodyWithMasses) {
  ActuatorParams params;
  Walker swayed(params);
  params.physical = false;
  Walker plain(params);
  double max = 0.0;
  for (Walker* w : {&plain, &swayed}) w->standUp();
  EXPECT_EQ(plain.out.stances.back().bodyRoll, swayed.out.stances.back().bodyRoll);
  for (int i = 0; i < 40; ++i) {
    for (Walker* w : {&plain, &swayed}) w->run(WalkRequest{25.0, 0.0, 0.0}, 1);
    for (std::size_t tick = 0; tick < kTicksPerMessage; ++tick)
      max = std::max(max, swayed.out.stances[tick].bodyRoll.deg());
    EXPECT_EQ(plain.out.stances.back().bodyRoll, Angle());
  }
  EXPECT_GT(max, 0.3);
}

}  // namespace
}  // namespace kelpie::actuator
