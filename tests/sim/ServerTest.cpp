// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <thread>

#include "robot/core/fields/Encoding.h"
#include "tools/sim/world/Server.h"

namespace kelpie::sim {
namespace {

struct Heard {
  int steps = 0;
  int sensors = 0;
  int images = 0;
  int vectorsDone = 0;
  bool goodbye = false;
  bool ordered = true;
  std::uint64_t hash = 1469598103934665603ULL;
  std::int64_t lastUs = 0;
};

void hear(const host::WorldStep& step, const std::vector<std::uint8_t>& body, Heard& heard) {
  ++heard.steps;
  heard.sensors += step.sensorsPresent ? 1 : 0;
  heard.vectorsDone += static_cast<int>(step.vectorsDone);
  heard.ordered = heard.ordered && step.time.us > heard.lastUs;
  heard.lastUs = step.time.us;
  for (const std::uint8_t byte : body) heard.hash = (heard.hash ^ byte) * 1099511628211ULL;
}

host::AgentReply replyTo(const host::WorldStep& step) {
  host::AgentReply reply;
  reply.motorPower = true;
  reply.gains = (1U << kJointCount) - 1U;
  if (!step.sensorsPresent) return reply;
  host::EffectorVector vector;
  vector.ticks = 4;
  vector.joints = 1U << index(Joint::headPan);
  JointAngles wanted;
  wanted[Joint::headPan] = Angle::deg(30);
  vector.targets.fill(host::rawOf(wanted));
  reply.vectors.push_back(vector);
  return reply;
}

// Plays until goodbye, or dies after `stepsToLive`.
Heard fakeAgent(host::Connection connection, int stepsToLive) {
  Heard heard;
  std::vector<std::uint8_t> body;
  while (heard.steps < stepsToLive) {
    const auto type = connection.receive(body);
    if (!type || *type == host::MessageType::goodbye) {
      heard.goodbye = type.ok();
      return heard;
    }
    host::WorldStep step;
    if (!decode(body.data(), body.size(), step)) return heard;
    hear(step, body, heard);
    if (step.imagePresent && connection.receive(host::MessageType::image, body)) {
      ++heard.images;
      for (const std::uint8_t byte : body) heard.hash = (heard.hash ^ byte) * 1099511628211ULL;
    }
    body.clear();
    encode(replyTo(step), body);
    if (!connection.send(host::MessageType::reply, body)) return heard;
  }
  return heard;
}

struct Played {
  Heard heard;
  std::string error;
};

Played played(std::uint64_t seed, int stepsToLive) {
  const auto field = *body::fieldDescription("2006");
  host::AgentHello hello;
  const auto setup = scenario("empty-goal", field, {hello}, seed);
  WorldParams params;
  params.referee.seconds = 1.0;
  World world(params, field, *setup, seed);
  auto pair = host::connectedPair({});
  std::vector<Agent> agents;
  agents.push_back({std::move(pair->first), hello});
  Played result;
  std::thread thread([&] { result.heard = fakeAgent(std::move(pair->second), stepsToLive); });
  const Status status = Server(world, agents, nullptr).run();
  agents.clear();
  thread.join();
  if (!status) result.error = status.error();
  return result;
}

TEST(Server, PlaysInLockStepToTheEnd) {
  const Played game = played(3, 1000);
  EXPECT_EQ(game.error, "");
  EXPECT_TRUE(game.heard.goodbye);
  EXPECT_TRUE(game.heard.ordered);
  EXPECT_EQ(game.heard.sensors, 31);  // 1 s / 32 ms
  EXPECT_EQ(game.heard.images, 30);
  EXPECT_EQ(game.heard.steps, 60);  // at 800 ms one step brings both
  EXPECT_NEAR(game.heard.vectorsDone, 30, 1);
}

TEST(Server, SameSeedGivesTheSameMatch) {
  const Played first = played(3, 1000);
  EXPECT_EQ(first.heard.hash, played(3, 1000).heard.hash);
  EXPECT_NE(first.heard.hash, played(4, 1000).heard.hash);
}

TEST(Server, AgentThatDiesIsNamedInOneLine) {
  const Played game = played(3, 10);
  EXPECT_NE(game.error.find("agent red 1"), std::string::npos) << game.error;
  EXPECT_EQ(game.error.find('\n'), std::string::npos);
}

// A match of one agent that dies after ten steps: what its second life, which comes when asked the
// `comesAt`th time, has heard.
Heard secondLife(int comesAt, bool needsFreePlace) {
  const auto field = *body::fieldDescription("2006");
  const auto setup = scenario("empty-goal", field, {host::AgentHello{}}, 3);
  WorldParams params;
  params.referee.seconds = 1.0;
  World world(params, field, *setup, 3);
  auto first = host::connectedPair({}), second = host::connectedPair({});
  std::vector<Agent> agents;
  agents.push_back({std::move(first->first), {}});
  int asked = 0;
  ServerHooks hooks;
  hooks.arrival = [&]() -> std::optional<Agent> {
    if ((needsFreePlace && agents[0].present) || ++asked != comesAt) return std::nullopt;
    return Agent{std::move(second->first), {}};
  };
  Heard heard;
  std::thread dies([&] { fakeAgent(std::move(first->second), 10); });
  std::thread comes([&] { heard = fakeAgent(std::move(second->second), 1000); });
  EXPECT_TRUE(Server(world, agents, nullptr, hooks).run());
  agents.clear();
  dies.join();
  comes.join();
  return heard;
}

TEST(Server, MatchWithoutAnybodyWaitsForWhoComes) {
  const Heard heard = secondLife(10, true);
  EXPECT_TRUE(heard.goodbye);
  EXPECT_GT(heard.steps, 40) << "of 60";
}

TEST(Server, WhoComesBeforeTheDeathOfTheOneBeforeIsKnownTakesItsPlaceThen) {
  const Heard heard = secondLife(1, false);
  EXPECT_TRUE(heard.goodbye);
  EXPECT_GT(heard.steps, 40) << "of 60";
}

// Runs the program with an agent that says hello and goes.
TEST(World, ProgramEndsWithCodeOneWhenItsAgentDies) {
  const std::string socket = "/tmp/kelpie-sim-test-" + std::to_string(getpid());
  const std::string command =
      std::string(KELPIE_WORLD) + " --socket " + socket + " --seconds 5 2>&1";
  FILE* world = popen(command.c_str(), "r");
  ASSERT_NE(world, nullptr);
  auto connection = host::Connection::connect(socket, {});
  ASSERT_TRUE(connection);
  std::vector<std::uint8_t> body;
  encode(host::AgentHello{}, body);
  ASSERT_TRUE(connection->send(host::MessageType::hello, body));
  fakeAgent(std::move(*connection), 5);
  std::string said;
  for (int c = fgetc(world); c != EOF; c = fgetc(world)) said += static_cast<char>(c);
  EXPECT_EQ(pclose(world) >> 8, 1);
  EXPECT_EQ(said.find("kelpie-world: agent red 1: "), 0U) << said;
  EXPECT_EQ(said.find('\n'), said.size() - 1);
}

TEST(Scenario, EmptyGoalStartsAnywhereOnTheField) {
  const auto field = *body::fieldDescription("2006");
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto setup = scenario("empty-goal", field, {{}}, seed);
    ASSERT_TRUE(setup);
    EXPECT_GE(setup->ball.x, 40.0);
    EXPECT_LE(setup->ball.y, 500.0);
    EXPECT_GE(distance(setup->ball, setup->players[0].start.position), 40.0);
  }
  EXPECT_FALSE(scenario("no-such", field, {{}}, 1));
}

}  // namespace
}  // namespace kelpie::sim
