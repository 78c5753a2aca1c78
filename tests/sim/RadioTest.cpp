// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tools/sim/world/Radio.h"

namespace kelpie::sim {
namespace {

RadioPacket packetOf(std::uint8_t byte) {
  RadioPacket packet;
  packet.bytes.push_back(byte);
  return packet;
}

constexpr TimeUs at(double seconds) { return {static_cast<std::int64_t>(1e6 * seconds)}; }
const std::vector<Point2<Field>> kPlaces = {{0, 0}, {100, 0}, {1000, 0}};

RadioParams sure() {
  RadioParams params;
  params.loss = params.jitter = 0.0;
  params.delay = 0.1;
  return params;
}

TEST(Radio, APacketReachesEveryOtherRobotAfterItsDelay) {
  Radio radio(sure(), 3, 1);
  radio.send(0, packetOf(7), at(1.0), kPlaces);
  EXPECT_TRUE(radio.take(1, at(1.09)).empty());
  ASSERT_EQ(1U, radio.take(1, at(1.1)).size());
  EXPECT_TRUE(radio.take(1, at(2.0)).empty());
  EXPECT_EQ(7, radio.take(2, at(2.0))[0].bytes[0]);
  EXPECT_TRUE(radio.take(0, at(2.0)).empty());
}

TEST(Radio, WhoIsDeafHearsNothingAndIsHeard) {
  Radio radio(sure(), 3, 1);
  radio.deafen(1);
  radio.send(0, packetOf(7), at(1.0), kPlaces);
  radio.send(1, packetOf(8), at(1.0), kPlaces);
  EXPECT_TRUE(radio.take(1, at(2.0)).empty());
  EXPECT_EQ(1U, radio.take(0, at(2.0)).size());
  EXPECT_EQ(2U, radio.take(2, at(2.0)).size());
}

TEST(Radio, WhoIsOutOfRangeHearsNothing) {
  RadioParams params = sure();
  params.range = 500.0;
  Radio radio(params, 3, 1);
  radio.send(0, packetOf(7), at(1.0), kPlaces);
  EXPECT_EQ(1U, radio.take(1, at(2.0)).size());
  EXPECT_TRUE(radio.take(2, at(2.0)).empty());
}

TEST(Radio, TheShareThatIsLostIsThatOfTheParameter) {
  RadioParams params = sure();
  params.loss = 0.25;
  Radio radio(params, 2, 3);
  std::size_t heard = 0;
  for (int i = 0; i < 4000; ++i) {
    radio.send(0, packetOf(1), at(i), {{0, 0}, {1, 0}});
    heard += radio.take(1, at(i + 0.5)).size();
  }
  EXPECT_NEAR(3000, static_cast<double>(heard), 100);
}

TEST(Radio, WhatDoesNotFitIntoOneAnswerIsLost) {
  Radio radio(sure(), 2, 1);
  for (std::uint8_t i = 0; i < 20; ++i) radio.send(0, packetOf(i), at(1.0), {{0, 0}, {1, 0}});
  EXPECT_EQ(kMaxPackets, radio.take(1, at(2.0)).size());
  EXPECT_TRUE(radio.take(1, at(2.0)).empty());
}

TEST(Radio, TheSameSeedLosesAndDelaysTheSame) {
  const auto heard = [](std::uint64_t seed) {
    RadioParams params;
    params.loss = 0.5;
    Radio radio(params, 2, seed);
    std::vector<std::size_t> counts;
    for (int i = 0; i < 100; ++i) {
      radio.send(0, packetOf(1), at(0.1 * i), {{0, 0}, {1, 0}});
      counts.push_back(radio.take(1, at(0.1 * i + 0.02)).size());
    }
    return counts;
  };
  EXPECT_EQ(heard(4), heard(4));
  EXPECT_NE(heard(4), heard(5));
}

}  // namespace
}  // namespace kelpie::sim
