// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <unistd.h>

#include <thread>

#include "robot/host/radio/UdpRadio.h"

namespace kelpie::host {
namespace {

// Ports of this run of the test alone.
std::uint16_t base() { return static_cast<std::uint16_t>(30000 + 16 * (getpid() % 1500)); }

RadioPacket packetOf(std::uint8_t byte) {
  RadioPacket packet;
  packet.bytes.push_back(byte);
  return packet;
}

bool heardWithin(UdpRadio& radio, RadioPacket& packet) {
  for (int i = 0; i < 200; ++i) {
    if (radio.receive(packet)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

TEST(UdpRadio, APacketReachesMatesAndOpponentsButNotItsSender) {
  auto one = UdpRadio::open({TeamColour::red, 1}, base());
  auto mate = UdpRadio::open({TeamColour::red, 4}, base());
  auto opponent = UdpRadio::open({TeamColour::blue, 4}, base());
  ASSERT_TRUE(one && mate && opponent);
  one->send(packetOf(7));
  RadioPacket packet;
  ASSERT_TRUE(heardWithin(*mate, packet));
  EXPECT_EQ(7, packet.bytes[0]);
  EXPECT_EQ(1U, packet.bytes.size());
  EXPECT_TRUE(heardWithin(*opponent, packet));
  EXPECT_FALSE(one->receive(packet));
  EXPECT_TRUE(packet.bytes.empty());
}

TEST(UdpRadio, TheSamePlayerTwiceIsOneLine) {
  const auto one = UdpRadio::open({TeamColour::red, 2}, base());
  ASSERT_TRUE(one);
  const auto again = UdpRadio::open({TeamColour::red, 2}, base());
  ASSERT_FALSE(again);
  EXPECT_NE(std::string::npos, again.error().find("radio: port " + std::to_string(base() + 2)));
}

}  // namespace
}  // namespace kelpie::host
