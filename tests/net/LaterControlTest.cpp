// SPDX-License-Identifier: Apache-2.0
// Packets of versions 8 and 18 byte by byte, as the league's header lays them out: nothing here
// comes from a codec of ours.
#include <gtest/gtest.h>

#include "robot/core/Random.h"
#include "robot/core/fields/FieldCheck.h"
#include "robot/net/GameListener.h"

namespace kelpie::net {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Second half of version 8: set, team 34 (red) kicks off and leads 2 : 1, 299 s to go; the ball was
// dropped in 9 s ago. Red 2 has pushed (40 s), red 4 is inactive (12 s), blue 1 is a substitute.
Bytes packet8() {
  Bytes bytes = {'R', 'G', 'm', 'e', 8, 77, 5, 2, 0, 1, 0, 0, 9, 0, 0x2b, 1, 30, 0};
  const Bytes blue = {12, 0, 1, 0, 0, 0};
  const Bytes red = {34, 1, 2, 0, 3, 0};
  Bytes players(22, 0);
  bytes.insert(bytes.end(), blue.begin(), blue.end());
  bytes.insert(bytes.end(), 42, 0xee);  // what the coach says, and the coach
  players[0] = 14;
  bytes.insert(bytes.end(), players.begin(), players.end());
  bytes.insert(bytes.end(), red.begin(), red.end());
  bytes.insert(bytes.end(), 42, 0xee);
  players[0] = 0;
  players[2] = 2, players[3] = 40;
  players[6] = 4, players[7] = 12;
  players[8] = 14;  // of the fifth, who is none of ours
  bytes.insert(bytes.end(), players.begin(), players.end());
  return bytes;
}

// First half of version 18: ready, team 34 (red, keeper black) kicks off, 0 : 3, 599 s to go. Blue
// 1 has left the field (20 s), blue 3 stood wrong (11), red 2 is on the bench.
Bytes packet18() {
  Bytes bytes = {'R', 'G', 'm', 'e', 18, 200, 7, 1, 0, 0, 1, 0, 1, 34, 0x57, 2, 45, 0};
  const Bytes red = {34, 1, 3, 1, 0, 0, 0, 0, 0xb0, 4};
  const Bytes blue = {12, 0, 9, 1, 3, 0, 0, 0, 0xb0, 4};
  Bytes players(40, 0);
  bytes.insert(bytes.end(), red.begin(), red.end());
  players[2] = 14;
  bytes.insert(bytes.end(), players.begin(), players.end());
  bytes.insert(bytes.end(), blue.begin(), blue.end());
  players[2] = 0;
  players[0] = 6, players[1] = 20;
  players[4] = 11, players[5] = 15;
  bytes.insert(bytes.end(), players.begin(), players.end());
  return bytes;
}

GameControlData decoded(const Bytes& bytes) {
  GameControlData data;
  EXPECT_FALSE(decodeControl(bytes.data(), bytes.size(), data));
  std::string why;
  EXPECT_TRUE(verify(data, &why)) << why;
  return data;
}

Bytes with(Bytes bytes, std::size_t place, std::uint8_t byte) {
  bytes[place] = byte;
  return bytes;
}

TEST(LaterControl, ThePacketsHaveTheLeaguesSizes) {
  EXPECT_EQ(packet8().size(), 158U);
  EXPECT_EQ(packet18().size(), 118U);
}

TEST(LaterControl, VersionEightTellsTheMatch) {
  const GameControlData data = decoded(packet8());
  EXPECT_EQ(data.state, PlayState::set);
  EXPECT_FALSE(data.firstHalf || data.dropBall);
  EXPECT_EQ(data.kickOff, TeamColour::red);
  EXPECT_EQ(data.secondsLeft, 299U);
  EXPECT_EQ(data.dropInSeconds, 9U);
  EXPECT_EQ(data.dropInTeam, TeamColour::blue);
  EXPECT_EQ(data.teams[0].number, 12U);
  EXPECT_EQ(data.teams[1].number, 34U);
  EXPECT_EQ(data.teams[0].score, 1U);
  EXPECT_EQ(data.teams[1].score, 2U);
  EXPECT_EQ(data.teams[1].colour, TeamColour::red);
}

TEST(LaterControl, VersionEightTellsEachPlayersPenalty) {
  const GameControlData data = decoded(packet8());
  const auto& red = data.teams[1].players;
  EXPECT_EQ(data.teams[0].players[0].penalty, ControlPenalty::other);
  EXPECT_EQ(data.teams[0].players[1].penalty, ControlPenalty::none);
  EXPECT_EQ(red[0].penalty, ControlPenalty::none);
  EXPECT_EQ(red[1].penalty, ControlPenalty::playerPushing);
  EXPECT_EQ(red[1].secondsLeft, 40U);
  EXPECT_EQ(red[3].penalty, ControlPenalty::other);
  EXPECT_EQ(red[3].secondsLeft, 12U);
}

TEST(LaterControl, VersionEighteenTellsTheMatch) {
  const GameControlData data = decoded(packet18());
  EXPECT_EQ(data.state, PlayState::ready);
  EXPECT_TRUE(data.firstHalf);
  EXPECT_FALSE(data.dropBall);
  EXPECT_EQ(data.kickOff, TeamColour::red) << "team 34";
  EXPECT_EQ(data.secondsLeft, 599U);
  EXPECT_EQ(data.dropInSeconds, kNoDropIn);
  EXPECT_EQ(data.teams[0].number, 34U);
  EXPECT_EQ(data.teams[0].colour, TeamColour::red);
  EXPECT_EQ(data.teams[1].score, 3U);
  EXPECT_EQ(data.teams[0].players[1].penalty, ControlPenalty::other);
  EXPECT_EQ(data.teams[1].players[0].penalty, ControlPenalty::leavingTheField);
  EXPECT_EQ(data.teams[1].players[0].secondsLeft, 20U);
  EXPECT_EQ(data.teams[1].players[2].penalty, ControlPenalty::other);
  EXPECT_EQ(data.teams[1].players[2].secondsLeft, 15U);
}

TEST(LaterControl, EachStateIsThatOfVersionFourAndStandbyIsInitial) {
  for (std::uint8_t state = 0; state < 5; ++state) {
    EXPECT_EQ(decoded(with(packet8(), 7, state)).state, static_cast<PlayState>(state));
    EXPECT_EQ(decoded(with(packet18(), 10, state)).state, static_cast<PlayState>(state));
  }
  EXPECT_EQ(decoded(with(packet18(), 10, 5)).state, PlayState::initial);
}

TEST(LaterControl, AClockThatHasRunOverCountsZero) {
  EXPECT_EQ(decoded(with(packet8(), 15, 0xff)).secondsLeft, 0U);
  EXPECT_EQ(decoded(with(packet18(), 15, 0xff)).secondsLeft, 0U);
}

TEST(LaterControl, ABallThatWasNeverDroppedInAndOneThatNobodyKicksOffAreReported) {
  EXPECT_EQ(decoded(with(with(packet8(), 12, 0xff), 13, 0xff)).dropInSeconds, kNoDropIn);
  for (const auto& data : {decoded(with(packet8(), 9, 2)), decoded(with(packet18(), 13, 255))}) {
    EXPECT_TRUE(data.dropBall);
    EXPECT_FALSE(gameStateFrom(data, TeamColour::red, 1).kickOff);
    EXPECT_FALSE(gameStateFrom(data, TeamColour::blue, 1).kickOff);
  }
}

TEST(LaterControl, NoOtherByteCostsThePacket) {
  for (const Bytes& bytes : {packet8(), packet18()})
    for (std::size_t place = 5; place < bytes.size(); ++place)
      if (place != (bytes[4] == 8 ? 7U : 10U))
        for (const int byte : {1, 99, 255})
          decoded(with(bytes, place, static_cast<std::uint8_t>(byte)));
}

TEST(LaterControl, AStateThatNobodyKnowsIsRefusedByItsReason) {
  GameControlData data;
  const Bytes eight = with(packet8(), 7, 5), eighteen = with(packet18(), 10, 6);
  EXPECT_EQ(decodeControl(eight.data(), 158, data), ControlRefusal::state);
  EXPECT_EQ(decodeControl(eighteen.data(), 118, data), ControlRefusal::state);
  EXPECT_EQ(decodeControl(packet8().data(), 157, data), ControlRefusal::size);
  EXPECT_FALSE(firstDifference(data, GameControlData{}, nullptr)) << "was changed";
}

ListenerState robotThatHears(const Bytes& bytes, TeamColour team, int number) {
  ListenerParams params;
  params.teamNumber = number;
  ListenerState state = listenerFor(team, 1);
  ControlPacket packet;
  for (const std::uint8_t byte : bytes) packet.bytes.push_back(byte);
  hear(packet, TimeUs{}, params, state);
  return state;
}

TEST(LaterControl, ARobotIsRuledByEither) {
  const GameState red = robotThatHears(packet8(), TeamColour::red, 34).game;
  EXPECT_TRUE(red.state == PlayState::set && red.kickOff && !red.penalised);
  EXPECT_EQ(red.ownScore, 2);
  const GameState blue = robotThatHears(packet18(), TeamColour::blue, 12).game;
  EXPECT_TRUE(blue.state == PlayState::ready && !blue.kickOff && blue.penalised);
  EXPECT_EQ(blue.ownScore, 3);
}

TEST(LaterControl, WhereNoColoursAreGivenTheNumberSaysWhichTeamIsTheRobots) {
  Bytes bytes = with(with(packet18(), 19, 3), 69, 4);  // 34 is black and 12 is white
  for (const TeamColour uniform : {TeamColour::red, TeamColour::blue}) {
    const ListenerState twelve = robotThatHears(bytes, uniform, 12);
    EXPECT_EQ(twelve.counts.taken, 1U);
    EXPECT_TRUE(twelve.game.penalised);
    EXPECT_EQ(twelve.game.ownScore, 3);
    EXPECT_TRUE(robotThatHears(bytes, uniform, 34).game.kickOff);
    EXPECT_EQ(robotThatHears(bytes, uniform, 7).counts.taken, 0U) << "foreign";
  }
}

}  // namespace
}  // namespace kelpie::net
