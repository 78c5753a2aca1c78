// SPDX-License-Identifier: Apache-2.0
// The motions that bring a fallen robot to its feet, as data; whether they do is measured by
// `kelpie evaluate fall`.
#include <gtest/gtest.h>

#include "actuator/motion/MotionData.h"
#include "robot/core/Time.h"

namespace kelpie::actuator {
namespace {

constexpr std::array<MotionKind, 4> kGetUps{MotionKind::getUpFront, MotionKind::getUpBack,
                                            MotionKind::getUpLeft, MotionKind::getUpRight};
constexpr std::size_t kOneSide = kLegJoints / 2;

TEST(GetUp, EndsInTheStanceOfTheWalkWithinThreeSeconds) {
  for (const MotionKind kind : kGetUps) {
    const MotionData& motion = standardMotions()[kind];
    ASSERT_FALSE(motion.frames.empty());
    EXPECT_EQ(motion.frames.back().legs, KeyLegs::stance);
    EXPECT_EQ(motion.returnTicks, 0U);
    EXPECT_LT(kTickSeconds * ticksOf(motion), 3.0);
  }
}

TEST(GetUp, StartsAtOnceAndGoesGently) {
  for (const MotionKind kind : kGetUps) {
    EXPECT_TRUE(standardMotions()[kind].atOnce);
    EXPECT_LE(standardMotions()[kind].slew.deg(), 6.0 + 1e-9);
  }
}

TEST(GetUp, FromTheRightIsFromTheLeftMirrored) {
  const MotionData& left = standardMotions()[MotionKind::getUpLeft];
  const MotionData& right = standardMotions()[MotionKind::getUpRight];
  ASSERT_EQ(left.frames.size(), right.frames.size());
  for (std::size_t f = 0; f < left.frames.size(); ++f)
    for (std::size_t j = 0; j < kLegJoints; ++j)
      EXPECT_EQ(left.frames[f].angles[j].rad(),
                right.frames[f].angles[(j + kOneSide) % kLegJoints].rad());
}

}  // namespace
}  // namespace kelpie::actuator
