// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>

#include "robot/core/fields/FieldCheck.h"
#include "robot/core/types/FrameOutput.h"
#include "tests/core/RandomValue.h"

namespace kelpie {
namespace {

TEST(FirstDifference, NamesTheFieldAndBothValues) {
  const auto a = std::make_unique<FrameOutput>();
  const auto b = std::make_unique<FrameOutput>();
  a->percepts.ball.distance = 100.5;
  b->percepts.ball.distance = 100.6;
  std::string path;
  EXPECT_TRUE(firstDifference(*a, *b, &path));
  EXPECT_EQ(path, "percepts.ball.distance: 100.5 != 100.6");
}

TEST(FirstDifference, NamesTheElementOfAVector) {
  Percepts a;
  a.landmarks.resize(3);
  Percepts b = a;
  b.landmarks[2].box.top = 7.0;
  std::string path;
  EXPECT_TRUE(firstDifference(a, b, &path));
  EXPECT_EQ(path, "landmarks[2].box.top: 0 != 7");
  b = a;
  b.counts.refused[31] = 9;
  EXPECT_TRUE(firstDifference(a, b, &path));
  EXPECT_EQ(path, "counts.refused[31]: 0 != 9");
}

TEST(FirstDifference, NamesLengths) {
  Percepts a;
  Percepts b;
  b.linePoints.resize(2);
  std::string path;
  EXPECT_TRUE(firstDifference(a, b, &path));
  EXPECT_EQ(path, "linePoints: 0 elements != 2");
}

TEST(FirstDifference, SeesTheSignOfZeroAndIgnoresEqualNans) {
  WalkRequest a;
  WalkRequest b;
  b.left = -0.0;
  EXPECT_TRUE(firstDifference(a, b, nullptr));
  a.left = b.left = std::nan("");
  EXPECT_FALSE(firstDifference(a, b, nullptr));
}

TEST(Verify, RandomValuesInRangePass) {
  Random random(5);
  const auto value = std::make_unique<FrameOutput>();
  randomise(*value, random);
  std::string why;
  EXPECT_TRUE(verify(*value, &why)) << why;
}

TEST(Verify, NamesTheNumberOutsideItsRange) {
  Command command;
  command.walk.forward = 61.0;
  std::string why;
  EXPECT_FALSE(verify(command, &why));
  EXPECT_EQ(why, "walk.forward: 61 cm/s is outside -45..60");
}

TEST(Verify, AngleRangesAreInDegrees) {
  HeadRequest head;
  head.headPan = Angle::deg(88);
  EXPECT_TRUE(verify(head, nullptr));
  head.headPan = Angle::deg(88.5);
  EXPECT_FALSE(verify(head, nullptr));
}

TEST(Verify, NotANumberIsNamed) {
  WorldModel world;
  world.covariance[4] = std::nan("");
  std::string why;
  EXPECT_FALSE(verify(world, &why));
  EXPECT_EQ(why, "covariance[4]: nan cm2, cm rad, rad2 is not finite");
}

TEST(Verify, EnumOutsideItsRangeIsNamed) {
  Percepts percepts;
  percepts.landmarks.resize(1);
  percepts.landmarks[0].kind = static_cast<LandmarkKind>(6);
  std::string why;
  EXPECT_FALSE(verify(percepts, &why));
  EXPECT_EQ(why, "landmarks[0].kind: 6 is outside 0..5");
}

}  // namespace
}  // namespace kelpie
