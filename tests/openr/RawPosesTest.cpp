// SPDX-License-Identifier: Apache-2.0
// Robots put together by hand from the robot's contract, through the agent's OPEN-R side: what the
// agent believes is what a person sees, and no sign can be other than it is.
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

#include "robot/host/primitives/DataVectors.h"
#include "robot/host/primitives/RawFrame.h"
#include "robot/openr/Contract.h"
#include "tests/openr/OpenedRobot.h"
#include "tests/openr/RawPoses.h"

namespace kelpie::openr {
namespace {

using agent::robotSenses;
using agent::Senses;

constexpr std::array<RawPose, kRawPoseCount> kPoses = {
    RawPose::stands,      RawPose::onNose, RawPose::onTail, RawPose::onLeftSide,
    RawPose::onRightSide, RawPose::onBack, RawPose::carried};

// How many of the poses are taken for what they are.
std::size_t rightlySeen(const Senses& senses) {
  std::size_t right = 0;
  for (std::size_t i = 0; i < kRawPoseCount; ++i)
    right += seenIn(sensedBy(senses, kPoses[i])) == kSeen[i] ? 1U : 0U;
  return right;
}

// What the agent sends for these angles.
std::array<slongword, kJointCount> sentFor(const JointAngles& joints, const Senses& senses) {
  OpenedRobot robot;
  JointFrame frame;
  frame.target = joints;
  OCommandVectorData& vector = robot.commanded(frame, senses);
  std::array<slongword, kJointCount> raw{};
  for (std::size_t i = 0; i < kJointCount; ++i)
    raw[i] = vector.GetData(static_cast<int>(i))->value[kTicksPerMessage - 1].value[0];
  return raw;
}

// How many of the poses the agent would send as the robot tells them. What it aims at is what it
// rightly sees, so that nothing that is wrong twice can look right.
std::size_t rightlySent(const Senses& senses) {
  std::size_t right = 0;
  for (const RawPose pose : kPoses) {
    const auto sent = sentFor(sensedBy(robotSenses(), pose).joints, senses);
    bool same = true;
    for (std::size_t i = 0; i < kJointCount; ++i)
      same = same && std::abs(sent[i] - rawValue(pose, kJointRows[i].locator)) <= 1;
    right += same ? 1U : 0U;
  }
  return right;
}

TEST(RawPoses, EachIsWhatAPersonSees) {
  for (std::size_t i = 0; i < kRawPoseCount; ++i)
    EXPECT_EQ(kSeen[i], seenIn(sensedBy(robotSenses(), kPoses[i])));
}

TEST(RawPoses, AJointThatCountsTheOtherWayIsSeen) {
  for (std::size_t i = 0; i < kJointCount; ++i) {
    Senses senses = robotSenses();
    senses.joints[i] = -senses.joints[i];
    EXPECT_LT(rightlySeen(senses), kRawPoseCount) << kJointRows[i].name;
  }
}

TEST(RawPoses, AnAccelerationThatCountsTheOtherWayIsSeen) {
  for (std::size_t i = 0; i < 3; ++i) {
    Senses senses = robotSenses();
    senses.acceleration[i] = -senses.acceleration[i];
    EXPECT_LT(rightlySeen(senses), kRawPoseCount) << i;
  }
}

TEST(RawPoses, AreSentAsTheyAreMeasured) { EXPECT_EQ(kRawPoseCount, rightlySent(robotSenses())); }

TEST(RawPoses, AJointThatIsSentTheOtherWayIsSeen) {
  for (std::size_t i = 0; i < kJointCount; ++i) {
    Senses senses = robotSenses();
    senses.joints[i] = -senses.joints[i];
    EXPECT_LT(rightlySent(senses), kRawPoseCount) << kJointRows[i].name;
  }
}

// Motor duty has the joint's sign: a hind leg that is pushed backward has a positive one.
TEST(RawPoses, DutyTurnsWithItsJoint) {
  OpenedRobot robot;
  RCRegion* region = host::newSensorRegion(0);
  auto& vector = *reinterpret_cast<OSensorFrameVectorData*>(region->Base());
  for (std::size_t i = 0; i < kJointCount; ++i) {
    OJointValue value;
    value.value = 0;
    value.pwmDuty = 256;
    OSensorValue& raw = vector.GetData(static_cast<int>(i))->frame[0];
    std::memcpy(static_cast<void*>(&raw), &value, sizeof raw);
  }
  std::array<SensorFrame, kTicksPerMessage> frames{};
  agent::SensorReader reader;
  reader.match(vector, robot.ids);
  ASSERT_TRUE(reader.read(vector, frames));
  EXPECT_EQ(-0.5, frames[0].duty[index(Joint::leftHindRotator)]);
  EXPECT_EQ(-0.5, frames[0].duty[index(Joint::rightHindRotator)]);
  EXPECT_EQ(0.5, frames[0].duty[index(Joint::leftFrontRotator)]);
  EXPECT_EQ(0.5, frames[0].duty[index(Joint::rightHindKnee)]);
  region->RemoveReference();
}

// The way back through the world's own code: it shares no sign with the agent's.
TEST(RawPoses, TheStandInForTheRobotTellsThemSo) {
  constexpr std::size_t kFirstPressure = index(Sensor::headTouch);  // scaled by the stand-in
  for (const RawPose pose : kPoses) {
    const host::RawSensors reported = host::rawOf(sensedBy(robotSenses(), pose));
    for (std::size_t i = 0; i < kJointCount; ++i)
      EXPECT_NEAR(reported.joints.value[i], rawValue(pose, kJointRows[i].locator), 1)
          << kJointRows[i].name;
    for (std::size_t i = 0; i < kFirstPressure; ++i)
      EXPECT_NEAR(reported.sensors[i], rawValue(pose, kSensorRows[i].locator), 1)
          << kSensorRows[i].name;
  }
}

TEST(RawPoses, EveryJointIsAwayFromItsMiddleInOne) {
  constexpr slongword kAway = 80000;  // urad, more than any play
  for (std::size_t i = 0; i < kJointCount; ++i) {
    bool away = false;
    for (const slongword raw : kRawRows[i].value) away = away || std::abs(raw) > kAway;
    EXPECT_STREQ(kRawRows[i].locator, kJointRows[i].locator);
    EXPECT_TRUE(away) << kRawRows[i].locator;
  }
}

TEST(RawPoses, EveryValueIsOneThatARobotCanTell) {
  constexpr double kDegree = 17453.2925;  // urad
  for (std::size_t i = 0; i < kRawRowCount; ++i) {
    const bool joint = i < kJointCount;
    const double min = joint ? kDegree * kJointRows[i].min : kSensorRows[i - kJointCount].min;
    const double max = joint ? kDegree * kJointRows[i].max : kSensorRows[i - kJointCount].max;
    for (const slongword raw : kRawRows[i].value) {
      EXPECT_GE(raw, min - 1.0) << kRawRows[i].locator;
      EXPECT_LE(raw, max + 1.0) << kRawRows[i].locator;
    }
  }
}

}  // namespace
}  // namespace kelpie::openr
