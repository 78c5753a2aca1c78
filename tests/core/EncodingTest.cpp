// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>

#include "robot/core/fields/Encoding.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/FrameOutput.h"
#include "robot/host/world/WorldProtocol.h"
#include "tests/core/RandomValue.h"

namespace kelpie {
namespace {

enum class Mood : std::int16_t { calm, wild };

struct Inner {
  Angle angle;
  bool present = false;
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("angle", &Inner::angle, "rad", -90, 90),
                     field("present", &Inner::present));
  }
};

struct Outer {
  std::uint16_t count = 0;
  Mood mood = Mood::calm;
  TimeUs time;
  std::array<float, 2> pair{};
  FixedVector<Inner, 3> inners;
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("count", &Outer::count), field("mood", &Outer::mood, "", 0, 1),
                     field("time", &Outer::time, "us"), field("pair", &Outer::pair, "cm", -5),
                     field("inners", &Outer::inners));
  }
};

Outer sample() {
  Outer outer;
  outer.count = 0x1234;
  outer.mood = Mood::wild;
  outer.time = {-2};
  outer.pair = {1.0F, -2.0F};
  outer.inners.push_back({Angle::rad(0.5), true});
  return outer;
}

// Written down from the ROS 1 wire format, not taken from a run.
const std::vector<std::uint8_t> kSampleBytes = {
    0x34, 0x12,                                      // count
    0x01, 0x00,                                      // mood
    0xfe, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff,  // time
    0x00, 0x00, 0x80, 0x3f, 0x00, 0x00, 0x00, 0xc0,  // pair: 1.0f, -2.0f
    0x01, 0x00, 0x00, 0x00,                          // one inner
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xe0, 0x3f,  // 0.5
    0x01};

TEST(Encoding, IsLittleEndianWithoutPaddingInFieldOrder) {
  std::vector<std::uint8_t> bytes = {0xaa};
  encode(sample(), bytes);
  ASSERT_EQ(bytes.size(), kSampleBytes.size() + 1);
  EXPECT_EQ(bytes[0], 0xaa) << "encode appends";
  EXPECT_TRUE(std::equal(kSampleBytes.begin(), kSampleBytes.end(), bytes.begin() + 1));
}

TEST(Encoding, DecodesWhatItEncoded) {
  Outer outer;
  outer.inners.resize(3);
  ASSERT_TRUE(decode(kSampleBytes.data(), kSampleBytes.size(), outer));
  std::string path;
  EXPECT_FALSE(firstDifference(outer, sample(), &path)) << path;
}

TEST(Encoding, TruncationAtEveryByteIsRefused) {
  for (std::size_t size = 0; size < kSampleBytes.size(); ++size) {
    Outer outer;
    EXPECT_FALSE(decode(kSampleBytes.data(), size, outer)) << size;
  }
}

TEST(Encoding, SurplusBytesAreRefused) {
  auto bytes = kSampleBytes;
  bytes.push_back(0);
  Outer outer;
  EXPECT_FALSE(decode(bytes.data(), bytes.size(), outer));
}

void expectRefusedWith(std::size_t at, std::uint8_t value) {
  auto bytes = kSampleBytes;
  bytes[at] = value;
  Outer outer;
  EXPECT_FALSE(decode(bytes.data(), bytes.size(), outer)) << "byte " << at;
}

TEST(Encoding, LengthOverTheCapacityIsRefused) {
  auto bytes = kSampleBytes;
  for (int i = 0; i < 2; ++i) bytes.insert(bytes.end(), kSampleBytes.end() - 9, kSampleBytes.end());
  bytes[20] = 3;
  Outer outer;
  EXPECT_TRUE(decode(bytes.data(), bytes.size(), outer)) << "as many as fit";
  bytes[20] = 4;
  EXPECT_FALSE(decode(bytes.data(), bytes.size(), outer)) << "the surplus one cut off";
  expectRefusedWith(23, 0xff);
}

TEST(Encoding, EnumOutsideItsRangeIsRefused) {
  expectRefusedWith(2, 2);
  expectRefusedWith(3, 0xff);
}

TEST(Encoding, BoolOtherThanZeroOrOneIsRefused) { expectRefusedWith(32, 2); }

template <class T>
void expectRoundTrip(std::uint64_t seed) {
  Random random(seed);
  auto in = std::make_unique<T>();
  auto out = std::make_unique<T>();
  for (int i = 0; i < 20; ++i) {
    randomise(*in, random);
    std::vector<std::uint8_t> bytes;
    encode(*in, bytes);
    ASSERT_TRUE(decode(bytes.data(), bytes.size(), *out));
    std::string path;
    ASSERT_FALSE(firstDifference(*in, *out, &path)) << path;
  }
}

TEST(Encoding, FrameInputSurvivesTheRoundTrip) { expectRoundTrip<FrameInput>(1); }
TEST(Encoding, FrameOutputSurvivesTheRoundTrip) { expectRoundTrip<FrameOutput>(2); }
TEST(Encoding, MotionInputSurvivesTheRoundTrip) { expectRoundTrip<MotionInput>(3); }
TEST(Encoding, WorldStepSurvivesTheRoundTrip) { expectRoundTrip<host::WorldStep>(5); }
TEST(Encoding, AgentReplySurvivesTheRoundTrip) { expectRoundTrip<host::AgentReply>(6); }
TEST(Encoding, MotionOutputSurvivesTheRoundTrip) { expectRoundTrip<MotionOutput>(4); }

}  // namespace
}  // namespace kelpie
