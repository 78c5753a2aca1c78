// SPDX-License-Identifier: Apache-2.0
// What the actuator tells of the work of the legs, and the odometry of weak ones.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "Walker.h"
#include "actuator/feeling/Effort.h"

namespace kelpie::actuator {
namespace {

constexpr std::size_t kSomeKnee = index(Joint::rightHindKnee);

MotionInput working(double duty) {
  MotionInput in;
  for (SensorFrame& tick : in.sensors) tick.duty[kSomeKnee] = duty;
  return in;
}

double effortAfter(const std::vector<double>& messages) {
  EffortState state;
  for (const double duty : messages) recordEffort(working(duty), true, state);
  return effort(state, GaitParams{});
}

TEST(Effort, IsTheMeanOfTheHardestJointOverTheLastStep) {
  // A step has 44 ticks: 11 messages.
  std::vector<double> messages(20, 1.0);
  messages.insert(messages.end(), 5, -0.2);
  messages.insert(messages.end(), 6, 0.4);
  EXPECT_NEAR(effortAfter(messages), (5 * 0.2 + 6 * 0.4) / 11.0, 1e-12);
}

TEST(Effort, OfTheHeadCountsNothing) {
  EffortState state;
  MotionInput in;
  for (SensorFrame& tick : in.sensors) tick.duty[index(Joint::headPan)] = 1.0;
  for (int i = 0; i < 20; ++i) recordEffort(in, true, state);
  EXPECT_EQ(effort(state, GaitParams{}), 0.0);
}

TEST(Effort, IsUnknownUntilHalfAStepHasBeenWalked) {
  EXPECT_EQ(effortAfter(std::vector<double>(5, 0.5)), 0.0);
  EXPECT_NEAR(effortAfter(std::vector<double>(6, 0.5)), 0.5, 1e-12);
}

TEST(Effort, IsForgottenWhenTheRobotStops) {
  EffortState state;
  for (int i = 0; i < 20; ++i) recordEffort(working(0.9), true, state);
  recordEffort(working(0.9), false, state);
  EXPECT_EQ(effort(state, GaitParams{}), 0.0);
}

TEST(Effort, StaysBetweenNoneAndFullWhateverTheSensorsSay) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double duty : {std::nan(""), 1e9, -1e9, inf, -inf, -0.3}) {
    const double reported = effortAfter(std::vector<double>(20, duty));
    EXPECT_GE(reported, 0.0);
    EXPECT_LE(reported, 1.0);
  }
}

TEST(Effort, IsReportedWhileWalkingOnly) {
  Walker walker;
  walker.standUp();
  for (SensorFrame& tick : walker.input.sensors) tick.duty[kSomeKnee] = 0.5;
  walker.run(WalkRequest{}, 20);
  EXPECT_EQ(walker.out.status.effort, 0.0);
  walker.run(WalkRequest{20.0, 0.0, 0.0}, 30);
  EXPECT_NEAR(walker.out.status.effort, 0.5, 1e-12);
}

TEST(Gain, FallsWhenMuchCurrentIsDrawnForLongAndRisesWhenLittleIs) {
  const GainParams params;
  GainState state;
  for (int i = 0; i < 20; ++i) stepGain(5000.0, params, state);
  EXPECT_FALSE(state.low);  // 0.64 s
  for (int i = 0; i < 100; ++i) stepGain(5000.0, params, state);
  EXPECT_TRUE(state.low);
  for (int i = 0; i < 500; ++i) stepGain(3000.0, params, state);
  EXPECT_TRUE(state.low);  // between the bounds all stays as it was
  for (int i = 0; i < 500; ++i) stepGain(2000.0, params, state);
  EXPECT_FALSE(state.low);
  for (int i = 0; i < 500; ++i) stepGain(3000.0, params, state);
  EXPECT_FALSE(state.low);
}

TEST(Gain, CurrentThatIsNotANumberChangesNothing) {
  const GainParams params;
  GainState state;
  for (int i = 0; i < 500; ++i) stepGain(5000.0, params, state);
  stepGain(std::nan(""), params, state);
  stepGain(std::numeric_limits<double>::infinity(), params, state);
  EXPECT_TRUE(state.low && std::isfinite(state.current));
}

TEST(Gain, WeakLegsHaveTheirOwnWalk) {
  Walker walker;
  walker.params.walks.weak.max.turn = 0.3;
  walker.standUp();
  walker.run(WalkRequest{0.0, 0.0, 1.0}, 30);
  EXPECT_NEAR(walker.state.walk.feet.turn, 1.0, 1e-9);
  EXPECT_FALSE(walker.out.status.lowGain);
  walker.input.batteryCurrent = 5000.0;
  walker.run(WalkRequest{0.0, 0.0, 1.0}, 300);
  EXPECT_TRUE(walker.out.status.lowGain);
  EXPECT_EQ(walker.state.walk.kind, WalkKind::weak);
  EXPECT_NEAR(walker.state.walk.feet.turn, 0.3, 1e-9);
}

TEST(Gain, AKickHasAllTheStrength) {
  Walker walker;
  walker.standUp();
  walker.input.batteryCurrent = 5000.0;
  walker.run(WalkRequest{}, 300);
  EXPECT_TRUE(walker.out.status.lowGain);
  Command kick;
  kick.motion = MotionKind::kickForward;
  walker.run(kick, 3);
  EXPECT_NE(walker.out.status.running, MotionKind::none);
  EXPECT_FALSE(walker.out.status.lowGain);
}

// What each message of a kick tells, in the order in which they are sent.
std::vector<double> gainsSent(const std::vector<KeyFrame>& frames) {
  Walker walker;
  MotionData& motion = walker.params.motions[MotionKind::kickForward];
  motion.frames.clear();
  for (const KeyFrame& key : frames) motion.frames.push_back(key);
  walker.standUp();
  Command kick;
  kick.motion = MotionKind::kickForward;
  std::vector<double> reported;
  for (int i = 0; i < 8; ++i) {
    walker.run(kick, 1);
    reported.push_back(walker.out.status.legGain);
  }
  return reported;
}

KeyFrame staysFor(std::uint32_t ticks, double gain) {
  KeyFrame key;
  key.ticks = ticks;
  key.gain = gain;
  return key;
}

TEST(MotionGain, IsReportedAsTheTicksThatWantItBeginToBePlayed) {
  const std::vector<double> reported{1.0, 0.4, 0.4, 0.7, 1.0, 1.0, 1.0, 1.0};
  EXPECT_EQ(gainsSent({staysFor(8, 0.4), staysFor(4, 0.7)}), reported);
}

TEST(MotionGain, OfAMessageIsTheGreatestThatItsTicksWant) {
  const std::vector<double> reported{1.0, 0.4, 1.0, 1.0, 0.3, 1.0, 1.0, 1.0};
  EXPECT_EQ(gainsSent({staysFor(6, 0.4), staysFor(6, 1.0), staysFor(4, 0.3)}), reported);
}

TEST(MotionGain, IsAllThereIsUnlessAFileSaysOtherwise) {
  for (const MotionData& motion : standardMotions().of)
    for (const KeyFrame& key : motion.frames) EXPECT_EQ(key.gain, 1.0);
}

}  // namespace
}  // namespace kelpie::actuator
