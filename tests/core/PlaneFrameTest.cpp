// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>

#include "robot/core/Random.h"
#include "robot/core/fields/Encoding.h"
#include "robot/core/types/PlaneFrame.h"
#include "tests/core/RandomValue.h"

namespace kelpie {
namespace {

constexpr std::uint8_t kClasses = 11;

// Runs of random length up to `longest`.
ClassNumbers planeOfRuns(Random& random, std::uint32_t longest) {
  ClassNumbers plane{};
  for (std::size_t at = 0; at < plane.size();) {
    const auto number = static_cast<std::uint8_t>(random.index(kClasses));
    for (std::uint32_t left = 1 + random.index(longest); left > 0 && at < plane.size(); --left)
      plane[at++] = number;
  }
  return plane;
}

PlaneCode codeOf(const ClassNumbers& plane) {
  PlaneCode code;
  encodePlane(plane, code);
  return code;
}

std::string errorOf(const PlaneCode& code) {
  ClassNumbers plane{};
  const Status read = decodePlane(code, kClasses, plane);
  return read ? "" : read.error();
}

TEST(PlaneCode, GivesBackEveryPlane) {
  Random random(5);
  for (const std::uint32_t longest : {1U, 2U, 15U, 16U, 17U, 271U, 272U, 5000U, 40000U}) {
    const ClassNumbers plane = planeOfRuns(random, longest);
    ClassNumbers again{};
    const Status read = decodePlane(codeOf(plane), kClasses, again);
    ASSERT_TRUE(read) << longest << ": " << read.error();
    EXPECT_EQ(again, plane) << longest;
  }
}

TEST(PlaneCode, OneColourTakes246BytesAndChessNoMoreThanItsPixels) {
  ClassNumbers plane{};
  EXPECT_EQ(codeOf(plane).size(), 246U);  // 122 runs of 271 and one of 218, two bytes each
  for (std::size_t i = 0; i < plane.size(); ++i) plane[i] = i % 2;
  EXPECT_EQ(codeOf(plane).size(), kImagePixels);
}

TEST(PlaneCode, EndingEarlyIsAnErrorWithThePlace) {
  PlaneCode code = codeOf(ClassNumbers{});
  code.resize(code.size() - 2);
  EXPECT_EQ(errorOf(code), "class plane, byte 244: ends after 33062 of 33280 pixels");
  code.resize(code.size() - 1);
  EXPECT_EQ(errorOf(code), "class plane, byte 243: ends within a run");
  EXPECT_NE(errorOf({}), "");
}

TEST(PlaneCode, GoingBeyondTheImageIsAnError) {
  PlaneCode code = codeOf(ClassNumbers{});
  code.push_back(0);
  EXPECT_EQ(errorOf(code), "class plane, byte 246: goes beyond the image");
  code.resize(code.size() - 1);
  code[245] += 1;  // the last run longer by one
  EXPECT_EQ(errorOf(code), "class plane, byte 245: goes beyond the image");
}

TEST(PlaneCode, UnknownClassIsAnError) {
  PlaneCode code = codeOf(ClassNumbers{});
  code[2] = 0xBF;
  EXPECT_EQ(errorOf(code), "class plane, byte 2: no class has the number 11");
}

TEST(PlaneCode, AnyByteBrokenIsAnErrorOrAnotherPlaneOfTheSameSize) {
  Random random(8);
  const PlaneCode whole = codeOf(planeOfRuns(random, 40));
  ClassNumbers plane{};
  for (int i = 0; i < 3000; ++i) {
    PlaneCode broken = whole;
    broken[random.index(static_cast<std::uint32_t>(whole.size()))] ^=
        static_cast<std::uint8_t>(1 + random.index(255));
    if (!decodePlane(broken, kClasses, plane)) continue;
    for (const std::uint8_t number : plane) ASSERT_LT(number, kClasses);
  }
}

TEST(PlaneFrame, HoldsAllOfTheInputButItsImage) {
  Random random(2);
  const auto frame = std::make_unique<PlaneFrame>();
  randomise(static_cast<FrameInput&>(*frame), random);
  frame->plane.clear();
  std::vector<std::uint8_t> bytes;
  encode(*frame, bytes);
  EXPECT_EQ(bytes.size(),
            encodedSize(static_cast<const FrameInput&>(*frame)) - encodedSize(frame->image) + 4);
  const auto again = std::make_unique<PlaneFrame>();
  ASSERT_TRUE(decode(bytes.data(), bytes.size(), *again));
  again->image = frame->image;
  EXPECT_FALSE(firstDifference(static_cast<const FrameInput&>(*frame),
                               static_cast<const FrameInput&>(*again), nullptr));
}

}  // namespace
}  // namespace kelpie
