// SPDX-License-Identifier: Apache-2.0
// What the body feels, of forces that are known: the duty of each leg joint is what holds a foot
// against its share of a force.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "Walker.h"
#include "actuator/feeling/Feeling.h"
#include "robot/core/Random.h"

namespace kelpie::actuator {
namespace {

struct Force {
  double right = 0.0;
  double ahead = 0.0;
  double up = 0.0;
};

// Of one foot: the torques whose work is the force's, by differences.
std::array<double, 3> torquesOf(const Force& force, LegId leg, const JointAngles& joints) {
  constexpr double kNudge = 1e-5;
  std::array<double, 3> torque{};
  for (std::size_t k = 0; k < 3; ++k) {
    JointAngles more = joints;
    JointAngles less = joints;
    Angle& up = more.angle[firstJoint(leg) + k];
    Angle& down = less.angle[firstJoint(leg) + k];
    up = Angle::rad(up.rad() + kNudge);
    down = Angle::rad(down.rad() - kNudge);
    const Point3<Torso> a = body::footPosition(leg, body::legAngles(more, leg));
    const Point3<Torso> b = body::footPosition(leg, body::legAngles(less, leg));
    torque[k] = (force.right * (a.x - b.x) + force.ahead * (a.y - b.y) + force.up * (a.z - b.z)) /
                (2.0 * kNudge);
  }
  return torque;
}

// All four feet push the ground alike.
void pushGround(const Force& force, MotionInput& in) {
  for (SensorFrame& tick : in.sensors)
    for (const LegId leg : kLegs) {
      const std::array<double, 3> torque = torquesOf(force, leg, tick.joints);
      for (std::size_t k = 0; k < 3; ++k) tick.duty[firstJoint(leg) + k] = torque[k];
    }
}

// A walk of a body without motors' losses, whose load has no free share.
class Feels : public ::testing::Test {
 protected:
  Feels() {
    walker.params.feeling.noLoad = 1e9;
    walker.params.walks.normal.freeLoad = {};
    walker.standUp();
  }
  // Walks with the feet pushing so, shares of a joint's torque for a cm, all four together.
  void walk(const WalkRequest& request, const Force& force, int messages) {
    for (int i = 0; i < messages; ++i) {
      pushGround({0.25 * force.right, 0.25 * force.ahead, 0.25 * force.up}, walker.input);
      walker.run(request, 1);
    }
  }
  const Feeling& feeling() const { return walker.out.status.feeling; }

  Walker walker;
};

const WalkRequest kAhead{20.0, 0.0, 0.0};
const WalkRequest kBack{-15.0, 0.0, 0.0};
const WalkRequest kLeft{0.0, 12.0, 0.0};

TEST(ContactForce, IsTheForceWhoseWorkIsThatOfTheJoints) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    MotionInput in;
    SensorFrame& tick = in.sensors.back();
    for (const LegId leg : kLegs)
      body::setLegAngles(
          tick.joints, leg,
          {Angle::deg(random.uniform(-40.0, 40.0)), Angle::deg(random.uniform(0.0, 30.0)),
           Angle::deg(random.uniform(60.0, 110.0))});
    const Force force{random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01), 0.02};
    pushGround(force, in);
    const SensedLegs legs = sensedLegs(tick, {});
    const ContactForce push = contactForceOf(legCurrents(legs, legs, legs, 7.5), legs);
    EXPECT_NEAR(push.forward, 4.0 * force.ahead, 4e-3);
    EXPECT_NEAR(push.left, -4.0 * force.right, 4e-3);
  }
}

TEST(ContactForce, OfAJointThatTurnsAsFastAsItCanIsNoCurrent) {
  SensedLegs last;
  SensedLegs middle;
  SensedLegs next;
  middle.angle[0] = 7.5 * kTickSeconds;
  next.angle[0] = 2.0 * middle.angle[0];
  middle.duty[0] = middle.duty[1] = 1.0;
  const LegCurrents currents = legCurrents(last, middle, next, 7.5);
  EXPECT_NEAR(currents[0], 0.0, 1e-12);
  EXPECT_NEAR(currents[1], 1.0, 1e-12);
  EXPECT_NEAR(rotatorCurrent(currents), 0.0, 1e-12);
}

TEST_F(Feels, NothingWhileItStands) {
  walk({}, {0.0, -0.1, 0.0}, 60);
  EXPECT_EQ(feeling().current, 0.0);
  EXPECT_EQ(feeling().load, 0.0);
  EXPECT_FALSE(feeling().stuck);
}

TEST_F(Feels, ThePushThatDoesNotMoveIt) {
  walk(kAhead, {0.0, -0.04, 0.0}, 60);
  // By a leg of 10 cm a quarter of it is each rotator's.
  EXPECT_NEAR(feeling().load, 0.1, 0.01);
  EXPECT_GT(feeling().current, 0.03);
  EXPECT_TRUE(feeling().stuck);
}

TEST_F(Feels, ThePushAgainstTheWayThatItGoes) {
  walk(kBack, {0.0, 0.04, 0.0}, 60);
  EXPECT_NEAR(feeling().load, 0.1, 0.01);
  walk(kLeft, {0.04, 0.0, 0.0}, 90);
  EXPECT_NEAR(feeling().load, 0.1, 0.01);
  walk(kLeft, {-0.04, 0.0, 0.0}, 60);
  EXPECT_LT(feeling().load, -0.08);
  EXPECT_FALSE(feeling().stuck);
}

TEST_F(Feels, TheFreeShareIsNoLoad) {
  walker.params.walks.normal.freeLoad.forward = 0.1 / 20.0;
  walk(kAhead, {0.0, -0.04, 0.0}, 60);
  EXPECT_NEAR(feeling().load, 0.0, 0.01);
  EXPECT_FALSE(feeling().stuck);
}

TEST_F(Feels, WhatThePushDoesToTheBodyIsNoLoad) {
  // Uphill: gravity and the feet are even.
  const double slope = 0.04 / walker.params.feeling.weight * 981.0;
  for (SensorFrame& tick : walker.input.sensors) tick.acceleration = {slope, 0.0, 940.0};
  walk(kAhead, {0.0, -0.04, 0.0}, 60);
  EXPECT_NEAR(feeling().load, 0.0, 0.01);
}

TEST_F(Feels, ThatItIsHeldWithinSevenTenthsOfASecondAndFreeWithinASecond) {
  walk(kAhead, {}, 60);
  EXPECT_FALSE(feeling().stuck);
  walk(kAhead, {0.0, -0.025, 0.0}, 21);
  EXPECT_TRUE(feeling().stuck);
  walk(kAhead, {}, 31);
  EXPECT_FALSE(feeling().stuck);
}

TEST_F(Feels, HeldOnlyWhenTheLoadLasts) {
  walk(kAhead, {}, 60);
  for (int i = 0; i < 10 && feeling().load < walker.params.feeling.stuckLoad; ++i)
    walk(kAhead, {0.0, -0.1, 0.0}, 1);
  EXPECT_GT(feeling().load, walker.params.feeling.stuckLoad);
  EXPECT_FALSE(feeling().stuck);
  walk(kAhead, {0.0, -0.1, 0.0}, 4);
  EXPECT_FALSE(feeling().stuck);
  walk(kAhead, {0.0, -0.1, 0.0}, 1);
  EXPECT_TRUE(feeling().stuck);
}

TEST_F(Feels, NotHeldWhereItLies) {
  for (SensorFrame& tick : walker.input.sensors) tick.acceleration = {0.0, -900.0, -400.0};
  walk(kAhead, {0.0, -0.1, 0.0}, 60);
  EXPECT_EQ(feeling().fallen, FallSide::left);
  EXPECT_FALSE(feeling().stuck);
}

TEST_F(Feels, APawThatIsPressedInTheAirAndNotOneThatStands) {
  const auto press = [&](bool pressed) {
    for (SensorFrame& tick : walker.input.sensors) tick.paw[index(LegId::leftFront)] = pressed;
  };
  press(true);
  walk({}, {}, 60);
  EXPECT_FALSE(feeling().pawBlocked[0]);
  walk(kAhead, {}, 30);
  EXPECT_TRUE(feeling().pawBlocked[0]);
  EXPECT_FALSE(feeling().pawBlocked[1]);
  press(false);
  walk(kAhead, {}, 14);
  EXPECT_FALSE(feeling().pawBlocked[0]);
}

TEST_F(Feels, FiniteThingsWhateverTheSensorsSay) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double wild : {std::nan(""), inf, -inf, 1e300, -1e300}) {
    walk(kAhead, {}, 60);
    for (SensorFrame& tick : walker.input.sensors) {
      tick.duty.fill(wild);
      tick.acceleration.fill(wild);
      tick.joints.angle.fill(Angle::rad(wild));
    }
    for (int i = 0; i < 30; ++i) {
      const MotionOutput out = step(walker.input, walker.params, walker.state);
      const Feeling& feeling = out.status.feeling;
      EXPECT_TRUE(feeling.current >= 0.0 && feeling.current <= 1.0) << wild;
      EXPECT_TRUE(feeling.load >= -1.0 && feeling.load <= 1.0) << wild;
    }
    for (SensorFrame& tick : walker.input.sensors) tick = {};
    walk(kAhead, {}, 90);
    EXPECT_NEAR(feeling().load, 0.0, 0.01) << wild;
  }
}

}  // namespace
}  // namespace kelpie::actuator
