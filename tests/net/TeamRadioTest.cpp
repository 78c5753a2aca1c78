// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "robot/net/TeamPacket.h"
#include "robot/net/TeamRadio.h"

namespace kelpie::net {
namespace {

constexpr double kMateIsAhead = 1000.0;  // s, of the mate's clock

// Player 1 of red, who hears player 2; its clock counts from another moment.
class TeamRadioTest : public testing::Test {
 protected:
  void hearAt(double now, double sent, std::uint16_t number, std::uint8_t player = 2,
              TeamColour team = TeamColour::red) {
    TeamPacket packet;
    packet.team = team;
    packet.made = TimeUs::fromSeconds(sent + kMateIsAhead);
    packet.message.player = player;
    packet.message.number = number;
    RadioPacket bytes;
    ASSERT_TRUE(encode(packet, bytes));
    hear(bytes, TimeUs::fromSeconds(now), TeamColour::red, 1, state, messages);
  }
  std::uint16_t refused(RadioRefusal reason) const {
    return state.counts.refused[static_cast<std::size_t>(reason)];
  }
  double age() const { return messages.back().age; }

  RadioState state;
  FixedVector<TeamMessage, kTeammates> messages;
};

TEST_F(TeamRadioTest, TheQuickestPacketIsTheMeasureOfAllOthers) {
  hearAt(1.05, 1.0, 1);
  EXPECT_NEAR(age(), kQuickest, 1e-6);
  hearAt(1.22, 1.2, 2);  // 30 ms quicker
  EXPECT_NEAR(age(), kQuickest, 1e-6);
  hearAt(1.52, 1.4, 3);
  EXPECT_NEAR(age(), kQuickest + 0.1, 1e-6);
}

TEST_F(TeamRadioTest, OfOneMateTheNewestMessageOfAFrameIsKept) {
  hearAt(1.0, 1.0, 1);
  hearAt(1.1, 1.1, 2);
  hearAt(1.1, 1.1, 8, 3);
  ASSERT_EQ(2U, messages.size());
  EXPECT_EQ(2, messages[0].number);
  EXPECT_EQ(3, state.counts.heard);
}

TEST_F(TeamRadioTest, GapsInTheNumbersAreLostMessages) {
  hearAt(1.0, 1.0, 5);
  hearAt(1.2, 1.2, 6);
  hearAt(1.6, 1.6, 9);
  EXPECT_EQ(2, state.counts.lost);
}

TEST_F(TeamRadioTest, DoubledAndOvertakenMessagesAreRefused) {
  hearAt(1.0, 1.0, 5);
  hearAt(1.1, 1.0, 5);
  hearAt(1.2, 0.9, 4);
  EXPECT_EQ(2, refused(RadioRefusal::doubled));
  EXPECT_EQ(1, state.counts.heard);
}

TEST_F(TeamRadioTest, OpponentsAndTheOwnEchoAreRefused) {
  hearAt(1.0, 1.0, 5, 2, TeamColour::blue);
  hearAt(1.0, 1.0, 5, 1);
  EXPECT_EQ(1, refused(RadioRefusal::otherTeam));
  EXPECT_EQ(1, refused(RadioRefusal::echo));
  EXPECT_TRUE(messages.empty());
}

TEST_F(TeamRadioTest, AMessageUnderWayForMoreThanASecondIsLate) {
  hearAt(1.0, 1.0, 5);
  hearAt(2.2, 1.1, 6);
  EXPECT_EQ(1, refused(RadioRefusal::late));
  hearAt(2.3, 2.3, 7);
  EXPECT_EQ(2, state.counts.heard);
}

TEST_F(TeamRadioTest, AMateThatHasRestartedIsHeardAgain) {
  hearAt(100.0, 100.0, 500);
  hearAt(103.0, 3.0, 1);  // its clock and its numbers begin anew
  EXPECT_EQ(2, state.counts.heard);
  hearAt(110.0, 10.0, 1);  // and once more after it was silent
  EXPECT_EQ(3, state.counts.heard);
}

TEST_F(TeamRadioTest, NumbersWrapRound) {
  hearAt(1.0, 1.0, 65535);
  hearAt(1.2, 1.2, 1);
  EXPECT_EQ(2, state.counts.heard);
  EXPECT_LE(state.counts.lost, 1);
}

}  // namespace
}  // namespace kelpie::net
