// SPDX-License-Identifier: Apache-2.0
// The whole object with a radio, in a robot's system whose network is a fake.
#include <gtest/gtest.h>

#include "FakeAnt.h"
#include "FakeWorld.h"
#include "robot/agent/Agent.h"
#include "robot/host/AgentStub.h"
#include "robot/host/HostSystem.h"

namespace kelpie::host {
namespace {

class AntHost : public HostSystem {
 public:
  using HostSystem::HostSystem;
  antError antCall(antEnvMsg& message) override { return ant.call(message); }
  antError antSend(const antEnvMsg& message) override { return ant.send(message); }
  void deliver() {
    for (; !ant.answers.empty(); ant.answers.pop_front())
      post(ant.answers.front().to, ant.answers.front().reply);
  }
  FakeAnt ant;
};

HostParams quiet() {
  HostParams params;
  params.printTo = nullptr;
  return params;
}

RadioPacket packetOf(const Bytes& bytes) {
  RadioPacket packet;
  for (const std::uint8_t byte : bytes) packet.bytes.push_back(byte);
  return packet;
}

template <class Packet>
Bytes bytesOf(const Packet& packet) {
  return {packet.bytes.begin(), packet.bytes.end()};
}

class AntRadioTest : public testing::Test {
 protected:
  // Plays steps of sensors and an image; before each, what the network does then.
  void play(const std::function<void(int)>& before) {
    source_.addSensors(8);
    for (WorldStep& step : source_.steps) step.imagePresent = true;
    Network network;
    int step = 0;
    network.tick = [&](TimeUs) {
      before(step++);
      system_.deliver();
    };
    const auto summary = system_.run(agentStub(*object_), network);
    ASSERT_TRUE(summary) << summary.error();
  }

  FakeSource source_;
  FakeLoops loops_;
  AntHost system_{source_, quiet()};
  std::unique_ptr<agent::Agent> object_ =
      std::make_unique<agent::Agent>(loops_, agent::kRobotPorts);
};

TEST_F(AntRadioTest, TheLoopsHearTheControllerAndTheTeamEachAtItsPort) {
  std::vector<bool> received;
  play([&](int step) {
    if (step == 2) received.push_back(system_.ant.comes(3838, {1, 2}));
    if (step == 4) received.push_back(system_.ant.comes(20050, {3}));
    if (step == 5) received.push_back(system_.ant.comes(20050, {4, 5, 6}));
  });
  EXPECT_EQ((std::vector<bool>{true, true, true}), received);
  ASSERT_EQ(1U, loops_.controls.size());
  EXPECT_EQ((Bytes{1, 2}), bytesOf(loops_.controls[0]));
  ASSERT_EQ(2U, loops_.packets.size());
  EXPECT_EQ(Bytes{3}, bytesOf(loops_.packets[0]));
  EXPECT_EQ((Bytes{4, 5, 6}), bytesOf(loops_.packets[1]));
}

TEST_F(AntRadioTest, WhatAFrameSaysIsBroadcastToTheTeamsPort) {
  play([&](int step) {
    if (step == 2 || step == 5) loops_.says = packetOf({static_cast<std::uint8_t>(step)});
    system_.ant.answerSends();
  });
  EXPECT_EQ((std::vector<Bytes>{{2}, {5}}), system_.ant.broadcasts);
  EXPECT_EQ(20050, system_.ant.lastPort);
}

TEST_F(AntRadioTest, WhatIsSaidWhileTheNetworkIsSlowIsLostAndNotHeldUp) {
  play([&](int step) {
    loops_.says = packetOf({static_cast<std::uint8_t>(step)});
    if (step == 4) system_.ant.answerSends();
  });
  EXPECT_EQ(std::vector<Bytes>{{0}}, system_.ant.broadcasts);
}

TEST_F(AntRadioTest, ARobotWithoutANetworkPlays) {
  system_.ant.refusesMemory = true;
  play([](int) {});
  EXPECT_EQ(8U, loops_.inputs.size());
  EXPECT_EQ(8U, loops_.exposures.size());
}

TEST(NoRadio, OnTheHostTheObjectAsksTheNetworkForNothingAndTakesNoPacket) {
  FakeSource source;
  source.addSensors(3);
  source.addImage(100000);
  FakeLoops loops;
  loops.says = packetOf({1});
  AntHost system(source, quiet());
  const auto object = std::make_unique<agent::Agent>(loops);
  ASSERT_TRUE(system.run(agentStub(*object), {}));
  EXPECT_EQ(0, system.ant.opened);
  EXPECT_EQ(1U, loops.says.bytes.size());
}

}  // namespace
}  // namespace kelpie::host
