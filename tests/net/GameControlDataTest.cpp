// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "robot/core/Random.h"
#include "robot/core/fields/FieldCheck.h"
#include "robot/net/GameControlData.h"

namespace kelpie::net {
namespace {

using Bytes = std::vector<std::uint8_t>;

GameControlData drawn(Random& random) {
  GameControlData data;
  data.state = static_cast<PlayState>(random.index(5));
  data.firstHalf = random.chance(0.5);
  data.kickOff = static_cast<TeamColour>(random.index(2));
  data.dropBall = data.kickOff == TeamColour::blue && random.chance(0.2);  // the wire has one word
  data.secondsLeft = random.index(86401);
  data.dropInTeam = static_cast<TeamColour>(random.index(2));
  data.dropInSeconds = random.chance(0.3) ? kNoDropIn : random.index(86401);
  data.teams[0].colour = static_cast<TeamColour>(random.index(2));
  data.teams[1].colour =
      data.teams[0].colour == TeamColour::red ? TeamColour::blue : TeamColour::red;
  for (ControlTeam& team : data.teams) {
    team.number = static_cast<std::uint32_t>(random.next());
    team.score = random.index(256);
    for (ControlPlayer& player : team.players)
      player = {static_cast<ControlPenalty>(random.index(11)), random.index(3601)};
  }
  return data;
}

// A match at which nothing is 0 that need not be.
GameControlData example() {
  GameControlData data;
  data.state = PlayState::set;
  data.kickOff = TeamColour::red;
  data.secondsLeft = 0x123;
  data.dropInTeam = TeamColour::red;
  data.dropInSeconds = 7;
  data.teams[0] = {5, TeamColour::blue, 2, {}};
  data.teams[1] = {6, TeamColour::red, 3, {}};
  data.teams[1].players[2] = {ControlPenalty::illegalDefender, 29};
  return data;
}

std::uint32_t wordAt(const Bytes& bytes, std::size_t place) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = (word << 8U) | bytes[place + i];
  return word;
}
void putWord(Bytes& bytes, std::size_t place, std::uint32_t word) {
  for (std::size_t i = 0; i < 4; ++i)
    bytes[place + i] = static_cast<std::uint8_t>((word >> (8 * i)) & 0xffU);
}

TEST(GameControlData, TheBytesAreThoseOfVersionFour) {
  const Bytes bytes = encodeControl(example());
  ASSERT_EQ(bytes.size(), 120U);
  EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 4), "RGme");
  const std::pair<std::size_t, std::uint32_t> words[] = {
      {4, 4},  {8, 2},  {12, 1}, {16, 1}, {20, 0x123}, {24, 1},  {28, 7},  {32, 5},
      {36, 0}, {40, 2}, {76, 6}, {80, 1}, {84, 3},     {104, 4}, {108, 29}};
  for (const auto& [place, word] : words) EXPECT_EQ(wordAt(bytes, place), word) << place;
}

TEST(GameControlData, WhatIsEncodedIsDecoded) {
  Random random(11);
  for (int i = 0; i < 1000; ++i) {
    const GameControlData data = drawn(random);
    const Bytes bytes = encodeControl(data);
    GameControlData back;
    ASSERT_FALSE(decodeControl(bytes.data(), bytes.size(), back)) << i;
    std::string path;
    EXPECT_FALSE(firstDifference(data, back, &path)) << path;
  }
}

GameControlData decodedWith(std::size_t place, std::uint32_t word) {
  Bytes bytes = encodeControl(example());
  putWord(bytes, place, word);
  GameControlData data;
  EXPECT_FALSE(decodeControl(bytes.data(), bytes.size(), data)) << place;
  EXPECT_EQ(data.state, PlayState::set) << place;
  return data;
}

TEST(GameControlData, AFieldThatCannotBeCostsThatFieldAlone) {
  EXPECT_FALSE(decodedWith(12, 2).firstHalf);
  EXPECT_TRUE(decodedWith(16, 2).dropBall);
  EXPECT_EQ(decodedWith(20, 0xffffffff).secondsLeft, 0U) << "a second too long";
  EXPECT_EQ(decodedWith(20, 86401).secondsLeft, 86400U);
  EXPECT_EQ(decodedWith(24, 2).dropInTeam, TeamColour::blue);
  EXPECT_EQ(decodedWith(28, 0xfffffffe).dropInSeconds, kNoDropIn);
  EXPECT_EQ(decodedWith(40, 256).teams[0].score, 255U);
  EXPECT_EQ(decodedWith(44, 14).teams[0].players[0].penalty, ControlPenalty::other);
  EXPECT_EQ(decodedWith(48, 3601).teams[0].players[0].secondsLeft, 3600U);
  EXPECT_EQ(decodedWith(48, 0xffffffff).teams[0].players[0].secondsLeft, 0U);
}

TEST(GameControlData, AnUnknownPenaltyIsOne) {
  EXPECT_TRUE(gameStateFrom(decodedWith(44, 14), TeamColour::blue, 1).penalised);
  EXPECT_TRUE(gameStateFrom(decodedWith(44, 0x100), TeamColour::blue, 1).penalised);
}

TEST(GameControlData, WithoutOneRedAndOneBlueTeamTheFirstIsBlueUntilItsNumberSaysOtherwise) {
  GameControlData bothRed = decodedWith(36, 1);
  EXPECT_EQ(bothRed.teams[0].colour, TeamColour::blue);
  EXPECT_EQ(bothRed.teams[1].colour, TeamColour::red);
  EXPECT_FALSE(bothRed.coloursGiven);
  const GameControlData black = decodedWith(36, 3);
  EXPECT_TRUE(black.coloursGiven && black.teams[0].colour == TeamColour::blue);
  const GameControlData againstBlack = decodedWith(80, 3);
  EXPECT_TRUE(againstBlack.coloursGiven && againstBlack.teams[1].colour == TeamColour::red);
}

struct Wrong {
  ControlRefusal reason;
  std::size_t place;
  std::uint32_t word;
};

TEST(GameControlData, WithoutHeaderVersionOrStateAPacketIsRefused) {
  const Wrong table[] = {{ControlRefusal::header, 0, 0x656d4752 + 1},
                         {ControlRefusal::version, 4, 5},
                         {ControlRefusal::version, 4, 0x104},
                         {ControlRefusal::state, 8, 5},
                         {ControlRefusal::state, 8, 0x102}};
  for (const Wrong& wrong : table) {
    Bytes bytes = encodeControl(example());
    putWord(bytes, wrong.place, wrong.word);
    GameControlData data;
    EXPECT_EQ(decodeControl(bytes.data(), bytes.size(), data), wrong.reason)
        << kControlRefusalNames[static_cast<std::size_t>(wrong.reason)].name;
    EXPECT_FALSE(firstDifference(data, GameControlData{}, nullptr)) << "was changed";
  }
}

TEST(GameControlData, APacketOfAnotherLengthIsRefused) {
  Bytes bytes = encodeControl(example());
  bytes.push_back(0);
  GameControlData data;
  for (std::size_t size = 0; size <= bytes.size(); ++size)
    EXPECT_EQ(decodeControl(bytes.data(), size, data) == ControlRefusal::size, size != 120);
}

TEST(GameControlData, WhateverBytesComeAreTakenOrCounted) {
  Random random(12);
  GameControlData data;
  ControlCounts counts;
  constexpr std::uint32_t kPackets = 100000;
  for (std::uint32_t i = 0; i < kPackets; ++i) {
    Bytes bytes = encodeControl(drawn(random));
    const std::uint32_t how = random.index(3);
    if (how == 0)
      for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.index(256));
    if (how == 1) bytes.resize(random.index(121));
    if (how == 2)
      for (std::uint32_t flips = random.index(4); flips > 0; --flips)
        bytes[random.index(120)] ^= static_cast<std::uint8_t>(1U << random.index(8));
    const auto refusal = decodeControl(bytes.data(), bytes.size(), data);
    std::string why;
    ASSERT_TRUE(refusal || verify(data, &why)) << why;
    ++(refusal ? counts.refused[static_cast<std::size_t>(*refusal)] : counts.taken);
  }
  EXPECT_GT(counts.taken, 0U);
  for (const ControlRefusal reason : {ControlRefusal::size, ControlRefusal::header,
                                      ControlRefusal::version, ControlRefusal::state})
    EXPECT_GT(counts.refused[static_cast<std::size_t>(reason)], 0U);
}

TEST(GameControlData, ARobotKnowsItsOwnMatch) {
  GameControlData data = example();
  const GameState red = gameStateFrom(data, TeamColour::red, 3);
  EXPECT_EQ(red.state, PlayState::set);
  EXPECT_TRUE(red.penalised && red.kickOff && red.firstHalf);
  EXPECT_EQ(red.ownScore, 3);
  EXPECT_EQ(red.opponentScore, 2);
  EXPECT_EQ(red.secondsLeft, 0x123);
  EXPECT_FALSE(gameStateFrom(data, TeamColour::red, 2).penalised);
  const GameState blue = gameStateFrom(data, TeamColour::blue, 3);
  EXPECT_FALSE(blue.penalised || blue.kickOff);
  EXPECT_EQ(blue.ownScore, 2);
  std::swap(data.teams[0], data.teams[1]);
  EXPECT_EQ(gameStateFrom(data, TeamColour::red, 3).ownScore, 3) << "teams come in any order";
  data.state = PlayState::playing;
  EXPECT_FALSE(gameStateFrom(data, TeamColour::red, 3).kickOff);
  EXPECT_FALSE(gameStateFrom(data, TeamColour::red, 0).penalised);
}

TEST(GameControlData, WhatARobotKnowsMakesAMatchOfWhichItKnowsTheSame) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const auto player = static_cast<std::uint8_t>(1 + random.index(4));
    const GameState game =
        gameStateFrom(drawn(random), static_cast<TeamColour>(random.index(2)), player);
    const ControlPacket packet = packetOf(controlFrom(game));
    GameControlData back;
    ASSERT_FALSE(decodeControl(packet.bytes.begin(), packet.bytes.size(), back));
    std::string path;
    EXPECT_FALSE(firstDifference(game, gameStateFrom(back, game.team, player), &path)) << path;
  }
}

}  // namespace
}  // namespace kelpie::net
