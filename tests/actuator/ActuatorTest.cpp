// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "actuator/Actuator.h"
#include "actuator/motion/JointLimits.h"
#include "robot/body/Ers7.h"
#include "robot/body/Legs.h"
#include "robot/core/Random.h"
#include "tests/actuator/Walker.h"

namespace kelpie::actuator {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double largestStep(const JointAngles& a, const JointAngles& b) {
  double largest = 0.0;
  for (std::size_t j = 0; j < kJointCount; ++j)
    largest = std::fmax(largest, std::fabs((a.angle[j] - b.angle[j]).deg()));
  return largest;
}

bool insideLimits(const JointAngles& joints) {
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const double a = joints.angle[j].deg();
    if (!(a >= body::kJointRanges[j].min - 1e-9 && a <= body::kJointRanges[j].max + 1e-9))
      return false;
  }
  return true;
}

JointAngles randomPose(Random& random) {
  JointAngles joints;
  for (std::size_t j = 0; j < kJointCount; ++j)
    joints.angle[j] =
        Angle::deg(random.uniform(body::kJointRanges[j].min, body::kJointRanges[j].max));
  return joints;
}

Command randomCommand(Random& random) {
  Command command;
  command.walk = {random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(-6, 6)};
  command.head.neckTilt = Angle::deg(random.uniform(-170, 170));
  command.head.headPan = Angle::deg(random.uniform(-170, 170));
  command.head.headNod = Angle::deg(random.uniform(-170, 170));
  command.head.speed = random.uniform(-1, 10);
  command.mouthOpen = random.chance(0.5);
  if (random.chance(0.1)) command.motion = static_cast<MotionKind>(random.index(kMotionKindCount));
  return command;
}

TEST(Start, NoJointIsAskedForMoreThanSixtyDegreesASecondOnTheWayToTheStance) {
  Random random(31);
  for (int i = 0; i < 50; ++i) {
    Walker w;
    JointAngles last = randomPose(random);
    for (SensorFrame& sensors : w.input.sensors) sensors.joints = last;
    w.run(Command{}, 30);
    EXPECT_FALSE(w.out.status.ready);
    w.run(Command{}, 110);
    EXPECT_TRUE(w.out.status.ready);
    for (const JointAngles& joints : w.ticks) {
      ASSERT_LE(largestStep(joints, last), 60.0 * 0.008 + 1e-9);
      last = joints;
    }
    const Stance stance = body::stanceFromLegs(last);
    EXPECT_NEAR(stance.shoulderHeight, w.stood().shoulderHeight, 1e-6);
    EXPECT_NEAR(stance.bodyTilt.deg(), w.stood().bodyTilt.deg(), 1e-6);
  }
}

TEST(Start, WalkRequestWaitsForTheRamp) {
  Walker w;
  w.run(WalkRequest{30, 0, 0}, 20);
  EXPECT_EQ(w.state.walk.feet.forward, 0.0);
}

TEST(Joints, StayInsideLimitsAndSlewForAThousandRandomCommands) {
  Random random(32);
  Walker w;
  w.standUp();
  JointAngles last = w.state.target;
  for (int i = 0; i < 1000; ++i) {
    w.ticks.clear();
    w.run(randomCommand(random), 1 + static_cast<int>(random.index(6)));
    for (const JointAngles& joints : w.ticks) {
      ASSERT_TRUE(insideLimits(joints));
      ASSERT_LE(largestStep(joints, last), 20.0 + 1e-9);
      last = joints;
    }
  }
}

TEST(Joints, WalkingChangesNoJointByMoreThanFourDegreesATick) {
  Random random(33);
  Walker w;
  w.standUp();
  JointAngles last = w.state.target;
  for (int i = 0; i < 200; ++i) {
    Command command = randomCommand(random);
    command.motion = MotionKind::none;
    w.ticks.clear();
    w.run(command, 5);
    for (const JointAngles& joints : w.ticks) {
      ASSERT_LE(largestStep(joints, last), 4.0 + 1e-9);
      last = joints;
    }
  }
}

TEST(Joints, AShoulderIsNeverWhereTheBodyIsOnTheWay) {
  Random random(6);
  JointAngles now = body::withinLimits({});
  JointAngles wanted;
  for (int tick = 0; tick < 20000; ++tick) {
    if (tick % 40 == 0)
      for (Angle& angle : wanted.angle) angle = Angle::deg(random.uniform(-135.0, 135.0));
    const JointAngles last = now;
    now = limited(wanted, last, {Angle::deg(4.0), Angle::deg(4.0)});
    for (std::size_t j = 0; j < kJointCount; ++j) {
      ASSERT_NEAR(now.angle[j].deg(), body::withinLimits(now).angle[j].deg(), 1e-9) << j;
      ASSERT_LE(std::fabs(now.angle[j].rad() - last.angle[j].rad()), Angle::deg(4.0).rad() + 1e-9);
    }
  }
}

TEST(Joints, NotANumberAndInfinityInTheCommandReachNoJoint) {
  for (const double bad : {kNan, std::numeric_limits<double>::infinity(), -1e300}) {
    Walker w;
    w.standUp();
    Command command;
    command.walk = {bad, bad, bad};
    command.head.neckTilt = command.head.headPan = command.head.headNod = Angle::rad(bad);
    command.head.speed = bad;
    w.run(command, 30);
    for (const JointAngles& joints : w.ticks) ASSERT_TRUE(insideLimits(joints));
    for (const Odometry& odometry : w.travelled) ASSERT_TRUE(std::isfinite(odometry.forward));
  }
}

TEST(Joints, NotANumberFromTheSensorsReachesNoJoint) {
  Walker w;
  for (SensorFrame& sensors : w.input.sensors)
    for (Angle& angle : sensors.joints.angle) angle = Angle::rad(kNan);
  w.run(Command{}, 80);
  for (const JointAngles& joints : w.ticks)
    for (const Angle angle : joints.angle) ASSERT_TRUE(std::isfinite(angle.rad()));
  EXPECT_NEAR(body::stanceFromLegs(w.ticks.back()).shoulderHeight, w.stood().shoulderHeight, 1e-6);
}

TEST(Odometry, OfAStraightWalkIsTheIntegralOfTheSpeedSomeTicksLate) {
  ActuatorParams params = exactWalks();
  params.odometry.delayTicks = 8;  // two whole messages
  Walker w(params);
  w.standUp();
  double walked = 0.0;
  double reported = 0.0;
  for (int i = 0; i < 100; ++i) {
    for (int tick = 0; tick < 4; ++tick)  // 90 cm/s2 up to 20 cm/s
      walked += 0.008 * std::fmin(20.0, 90.0 * 0.008 * (4 * i + tick + 1));
    w.run(WalkRequest{20, 0, 0}, 1);
    reported += w.out.odometry.forward;
    ASSERT_EQ(w.out.odometry.left, 0.0);
  }
  EXPECT_NEAR(walked - reported, 8 * 0.008 * 20.0, 1e-9);
}

TEST(Odometry, TellsTheRealSpeedWhateverTheFeetDo) {
  ActuatorParams params = exactWalks();
  params.odometry.delayTicks = 0;
  params.walks.normal.calibration.forward.scale = 0.5;
  params.walks.normal.calibration.left.scale = 0.7;
  params.walks.normal.odometry.forward.ahead = 0.5;
  params.walks.normal.odometry.left.left = 0.7;
  Walker w(params);
  w.standUp();
  w.run(WalkRequest{6, 3, 0}, 60);
  EXPECT_NEAR(w.out.odometry.forward, 6 * 0.032, 1e-9);
  EXPECT_NEAR(w.out.odometry.left, 3 * 0.032, 1e-9);
  EXPECT_NEAR(w.state.walk.feet.forward, 12.0, 1e-9);
}

// The joints of this walker do what is commanded at once.
TEST(Odometry, OfTheStandingFeetsJointsIsTheSpeedOfTheFeet) {
  ActuatorParams params = exactWalks();
  WalkOdometry& odometry = params.walks.normal.odometry;
  odometry = {};
  odometry.forward.joints = odometry.left.joints = odometry.turn.joints = 1.0;
  Walker w(params);
  w.standUp();
  w.run(WalkRequest{10, 4, 0.3}, 60);
  w.input.sensors[0].joints = w.input.sensors[1].joints = w.ticks[w.ticks.size() - 4];
  Odometry sum;
  for (int i = 0; i < 110; ++i) {
    for (std::size_t tick = 0; tick < 4; ++tick)
      w.input.sensors[tick].joints = w.ticks[w.ticks.size() - 4 + tick];
    w.out = step(w.input, w.params, w.state);
    for (const JointFrame& frame : w.out.joints) w.ticks.push_back(frame.target);
    sum.forward += w.out.odometry.forward;
    sum.left += w.out.odometry.left;
    sum.turn = sum.turn + w.out.odometry.turn;
  }
  const double seconds = 110 * 0.032;
  EXPECT_NEAR(sum.forward, 10 * seconds, 0.05 * 10 * seconds);
  EXPECT_NEAR(sum.left, 4 * seconds, 0.1 * 4 * seconds);
  EXPECT_NEAR(sum.turn.rad(), 0.3 * seconds, 0.05 * 0.3 * seconds);
}

TEST(Odometry, OfARobotThatStandsIsNothingWhateverItsJointsSay) {
  Random random(9);
  Walker w;
  w.params.walks.normal.odometry.forward.joints = 1.0;
  w.standUp();
  for (int i = 0; i < 50; ++i) {
    for (SensorFrame& sensors : w.input.sensors)
      for (Angle& angle : sensors.joints.angle)
        angle = angle + Angle::rad(random.gaussian(0, 0.01));
    w.out = step(w.input, w.params, w.state);
    ASSERT_EQ(w.out.odometry.forward, 0.0);
    ASSERT_EQ(w.out.odometry.variance.forward, 0.0);
  }
}

TEST(Odometry, OfAMotionIsWhatItsFileSaysAsUncertainAsThat) {
  ActuatorParams params = exactWalks();
  params.motions[MotionKind::wedge].way = {3.0, -1.0, Angle::deg(4), 2.0, 1.0, Angle::deg(5)};
  Walker w(params);
  w.standUp();
  Command command;
  command.motion = MotionKind::wedge;
  w.run(command, 40);
  Odometry sum;
  for (const Odometry& odometry : w.travelled) {
    sum.forward += odometry.forward;
    sum.turn = sum.turn + odometry.turn;
    sum.variance.left += odometry.variance.left;
    sum.variance.turn += odometry.variance.turn;
  }
  EXPECT_NEAR(sum.forward, 3.0, 0.1);
  EXPECT_NEAR(sum.turn.deg(), 4.0, 1e-9);
  EXPECT_NEAR(std::sqrt(sum.variance.left), 1.0, 0.7);  // beside the variance of such a way walked
  EXPECT_NEAR(Angle::rad(std::sqrt(sum.variance.turn)).deg(), 5.0, 0.3);
}

TEST(Odometry, VarianceGrowsWithTheWay) {
  Walker w;
  w.standUp();
  w.run(WalkRequest{10, 0, 0}, 60);
  const double slow = w.out.odometry.variance.forward;
  w.run(WalkRequest{20, 0, 0}, 60);
  EXPECT_GT(slow, 0.0);
  EXPECT_NEAR(w.out.odometry.variance.forward, 2.0 * slow, 1e-9);
}

// Four steps of one tick, each turned by what was turned before it.
TEST(Odometry, TurningWithinAMessageBendsTheWay) {
  ActuatorParams params = exactWalks();
  params.odometry.delayTicks = 0;
  Walker w(params);
  w.standUp();
  w.run(WalkRequest{5, 0, 1.5}, 50);
  double forward = 0.0;
  double left = 0.0;
  for (int i = 0; i < 4; ++i) {
    forward += 5 * 0.008 * std::cos(i * 1.5 * 0.008);
    left += 5 * 0.008 * std::sin(i * 1.5 * 0.008);
  }
  EXPECT_NEAR(w.out.odometry.forward, forward, 1e-12);
  EXPECT_NEAR(w.out.odometry.left, left, 1e-12);
  EXPECT_NEAR(w.out.odometry.turn.rad(), 4 * 1.5 * 0.008, 1e-12);
}

TEST(Status, TellsTheMotionAndHowLongItStillTakes) {
  Walker w;
  w.standUp();
  Command kick;
  kick.motion = MotionKind::kickForward;
  w.run(kick, 1);
  EXPECT_EQ(w.out.status.running, MotionKind::kickForward);
  const double left = w.out.status.secondsLeft;
  EXPECT_GT(left, 0.2);
  w.run(kick, 2);
  EXPECT_NEAR(w.out.status.secondsLeft, left - 0.064, 1e-9);
  w.run(kick, 40);
  EXPECT_EQ(w.out.status.running, MotionKind::none);  // one request, one kick
  w.run(Command{}, 1);
  w.run(kick, 1);
  EXPECT_EQ(w.out.status.running, MotionKind::kickForward);
}

TEST(Outputs, LedsPassAndTheStanceIsThatOfTheSensedLegs) {
  Walker w;
  w.standUp();
  Command command;
  command.leds = 0x5a5a;
  w.run(command, 1);
  for (const JointFrame& frame : w.out.joints) EXPECT_EQ(frame.leds, 0x5a5au);
  EXPECT_NEAR(w.out.stances.back().shoulderHeight, w.stood().shoulderHeight, 1e-9);
  EXPECT_NEAR(w.out.stances.back().bodyTilt.rad(), w.stood().bodyTilt.rad(), 1e-9);
}

TEST(Outputs, AnEarStaysUpForASecondAtMost) {
  Walker w;
  w.standUp();
  Command command;
  command.ears.leftUp = true;
  w.run(command, 30);
  EXPECT_TRUE(w.out.joints.back().ears.leftUp);
  EXPECT_FALSE(w.out.joints.back().ears.rightUp);
  w.run(command, 2);
  EXPECT_FALSE(w.out.joints.back().ears.leftUp);
  w.run(Command{}, 1);
  w.run(command, 1);
  EXPECT_TRUE(w.out.joints.back().ears.leftUp);
}

TEST(Outputs, TheSameInputsGiveTheSameBits) {
  Walker a;
  Walker b;
  for (const WalkRequest& walk : {WalkRequest{}, {20, 3, 1}, {0, 0, -2}}) {
    a.run(walk, 40);
    b.run(walk, 40);
  }
  for (std::size_t t = 0; t < a.ticks.size(); ++t) ASSERT_EQ(a.ticks[t].angle, b.ticks[t].angle);
}

}  // namespace
}  // namespace kelpie::actuator
