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
  // What the network answers at once comes after the method of the object that asked.
  antError antSend(const antEnvMsg& message) override {
    const antError error = ant.send(message);
    deliver();
    return error;
  }
  void deliver() {
    for (; !ant.answers.empty(); ant.answers.pop_front())
      post(ant.answers.front().to, ant.answers.front().reply);
  }
  FakeAnt ant;
};

// Tells the network when it was started: from then on its joints move.
class StartedAgent : public agent::Agent {
 public:
  StartedAgent(agent::Loops& loops, FakeAnt& ant) : Agent(loops, agent::kRobotPorts), ant_(ant) {}
  OStatus DoStart(const OSystemEvent& event) override {
    const OStatus status = Agent::DoStart(event);
    ant_.started = true;
    return status;
  }

 private:
  FakeAnt& ant_;
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
  // Plays steps of sensors and an image; before each, what the network does then. Whatever that is,
  // no method of the object waits for it once it is started.
  void play(const std::function<void(int)>& before, std::uint32_t steps = 8) {
    source_.addSensors(steps);
    for (WorldStep& step : source_.steps) step.imagePresent = true;
    Network network;
    int step = 0;
    network.tick = [&](TimeUs) {
      before(step++);
      system_.deliver();
    };
    const auto summary = system_.run(agentStub(*object_), network);
    ASSERT_TRUE(summary) << summary.error();
    EXPECT_TRUE(system_.ant.started);
    EXPECT_EQ(0, system_.ant.lateCalls);
    EXPECT_EQ(steps, loops_.inputs.size());
  }

  FakeSource source_;
  FakeLoops loops_;
  AntHost system_{source_, quiet()};
  std::unique_ptr<agent::Agent> object_ = std::make_unique<StartedAgent>(loops_, system_.ant);
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
  EXPECT_EQ(8U, loops_.exposures.size());
}

// Four seconds: nobody answers at the start, then one answers to messages.
TEST_F(AntRadioTest, WhatCouldNotBeOpenedAtTheStartIsOpenedByMessages) {
  system_.ant.callsServed = 0;
  std::vector<bool> received;
  play(
      [&](int step) {
        if (step == 50 || step == 100) received.push_back(system_.ant.comes(3838, {1}));
        if (step == 100) received.push_back(system_.ant.comes(20050, {2}));
      },
      120);
  EXPECT_EQ(2, system_.ant.calls) << "one for each port";
  EXPECT_EQ((std::vector<bool>{false, true, true}), received);
}

// Six seconds: traffic, the network lost and silent about it, traffic again.
TEST_F(AntRadioTest, AWholeLifeOfTheNetworkHoldsUpNoSensors) {
  std::vector<bool> received;
  play(
      [&](int step) {
        if (step == 25) loops_.says = packetOf({1});
        if (step == 25) received.push_back(system_.ant.comes(3838, {2}));
        if (step == 30) system_.ant.silent = true;
        if (step == 30) system_.ant.lose();
        if (step == 70) received.push_back(system_.ant.comes(20050, {3}));
        if (step == 80) system_.ant.silent = false;
        if (step == 150) loops_.says = packetOf({4});
        if (step == 150) received.push_back(system_.ant.comes(20050, {5}));
        system_.ant.answerSends();
      },
      190);
  EXPECT_EQ((std::vector<bool>{true, false, true}), received);
  EXPECT_EQ((std::vector<Bytes>{{1}, {4}}), system_.ant.broadcasts);
  EXPECT_EQ(1U, loops_.controls.size());
  EXPECT_EQ(1U, loops_.packets.size());
  EXPECT_EQ(8, system_.ant.calls) << "two buffers, an endpoint and a port, for each of two ports";
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
