// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "robot/core/Checksum.h"
#include "robot/core/Random.h"
#include "robot/core/fields/Encoding.h"
#include "robot/core/fields/FieldCheck.h"
#include "robot/net/TeamPacket.h"

namespace kelpie::net {
namespace {

TeamPacket fullest() {
  TeamPacket packet;
  packet.team = TeamColour::blue;
  packet.made = TimeUs{123456789};
  packet.message.player = 3;
  packet.message.number = 77;
  packet.message.note.role = Role::striker;
  packet.message.note.timeToBall = 2.5;
  packet.message.note.wanted = {100.0, 200.0};
  packet.message.pose.position = {12.0, 345.0};
  for (std::size_t i = 0; i < kOpponents; ++i) packet.message.opponents.push_back({});
  for (std::size_t i = 0; i < kSharedObstacles; ++i) packet.message.obstacles.push_back({});
  return packet;
}

RadioPacket bytesOf(const TeamPacket& packet) {
  RadioPacket bytes;
  EXPECT_TRUE(encode(packet, bytes));
  return bytes;
}

std::optional<RadioRefusal> refusalOf(const RadioPacket& bytes) {
  TeamPacket packet;
  return decode(bytes, packet);
}

TEST(TeamPacket, TheFullestMessageFitsIntoOneDatagramAndComesBackBitForBit) {
  const TeamPacket sent = fullest();
  const RadioPacket bytes = bytesOf(sent);
  EXPECT_LE(bytes.bytes.size(), kMaxPacketBytes);
  TeamPacket got;
  ASSERT_FALSE(decode(bytes, got));
  std::string difference;
  EXPECT_FALSE(firstDifference(sent.message, got.message, &difference)) << difference;
  EXPECT_EQ(sent.team, got.team);
  EXPECT_EQ(sent.made.us, got.made.us);
}

TEST(TeamPacket, ItsLayoutIsTheDocumentedOne) {
  const RadioPacket packet = bytesOf(fullest());
  const auto& bytes = packet.bytes;
  EXPECT_EQ('K', bytes[0]);
  EXPECT_EQ('P', bytes[3]);
  EXPECT_EQ(2, bytes[4]);
  EXPECT_EQ(1, bytes[5]);  // blue
  EXPECT_EQ(bytes.size(), bytes[6] + 256U * bytes[7]);
  EXPECT_EQ(3, bytes[kTeamPacketHeader]);  // the message begins with the player
}

TEST(TeamPacket, EachThingThatCanBeWrongHasItsReason) {
  const RadioPacket good = bytesOf(fullest());
  RadioPacket bad = good;
  bad.bytes[0] = 'X';
  EXPECT_EQ(RadioRefusal::foreign, refusalOf(bad));
  bad = good;
  bad.bytes.resize(10);
  EXPECT_EQ(RadioRefusal::foreign, refusalOf(bad));
  bad = good;
  bad.bytes[4] = 1;
  EXPECT_EQ(RadioRefusal::version, refusalOf(bad));
  bad = good;
  bad.bytes.resize(good.bytes.size() - 1);
  EXPECT_EQ(RadioRefusal::size, refusalOf(bad));
  bad = good;
  bad.bytes.push_back(0);
  EXPECT_EQ(RadioRefusal::size, refusalOf(bad));
  bad = good;
  bad.bytes[kTeamPacketHeader + 20] ^= 1;
  EXPECT_EQ(RadioRefusal::check, refusalOf(bad));
  TeamPacket far = fullest();
  far.message.note.timeToBall = 1e9;
  EXPECT_EQ(RadioRefusal::broken, refusalOf(bytesOf(far)));
  far = fullest();
  far.message.player = 9;
  EXPECT_EQ(RadioRefusal::broken, refusalOf(bytesOf(far)));
}

TEST(TeamPacket, AnyFlippedBitIsNoticed) {
  const RadioPacket good = bytesOf(fullest());
  for (std::size_t bit = 0; bit < 8 * good.bytes.size(); ++bit) {
    RadioPacket bad = good;
    bad.bytes[bit / 8] = static_cast<std::uint8_t>(bad.bytes[bit / 8] ^ (1U << (bit % 8)));
    EXPECT_TRUE(refusalOf(bad)) << bit;
  }
}

TEST(TeamPacket, RandomBytesAreRefused) {
  Random random(5);
  const RadioPacket good = bytesOf(fullest());
  for (int i = 0; i < 20000; ++i) {
    RadioPacket bad;
    bad.bytes.resize(random.index(kMaxPacketBytes + 1));
    for (std::size_t k = 0; k < bad.bytes.size(); ++k)
      bad.bytes[k] = k < 8 && random.chance(0.9) ? good.bytes[k]
                                                 : static_cast<std::uint8_t>(random.index(256));
    EXPECT_TRUE(refusalOf(bad));
  }
}

// It is finite, so that only what no sender writes tells.
TEST(TeamPacket, AnAngleOfManyTurnsIsBroken) {
  const TeamPacket sent = fullest();
  RadioPacket bytes = bytesOf(sent);
  std::vector<std::uint8_t> pose;
  kelpie::encode(sent.message.pose.position, pose);
  const auto at = std::search(bytes.bytes.begin(), bytes.bytes.end(), pose.begin(), pose.end());
  const double heading = 1e300;
  std::memcpy(at + pose.size(), &heading, sizeof heading);
  const std::uint32_t none = 0;
  std::memcpy(bytes.bytes.begin() + 16, &none, sizeof none);
  const std::uint32_t check = crc32(bytes.bytes.begin(), bytes.bytes.size());
  std::memcpy(bytes.bytes.begin() + 16, &check, sizeof check);
  EXPECT_EQ(RadioRefusal::broken, refusalOf(bytes));
}

}  // namespace
}  // namespace kelpie::net
