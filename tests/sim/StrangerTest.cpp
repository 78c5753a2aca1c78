// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <thread>

#include "robot/core/fields/Encoding.h"
#include "robot/host/world/Messages.h"
#include "tools/sim/world/Server.h"

namespace kelpie::sim {
namespace {

using host::MessageType;

constexpr double kLimit = 0.05;  // s of real time for each answer
constexpr int kSteps = 30;       // of half a second, but for what comes at the same time

struct Outcome {
  bool over = false;
  double seconds = 0.0;  // simulated
  std::vector<std::string> lines;

  std::string said() const {
    std::string all;
    for (const std::string& line : lines) all += line + "\n";
    return all;
  }
};

using Client = std::function<void(const std::string& socket)>;

void sleep(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

// Half a second of a match of one robot, whose agent is what `client` does at the socket. `pace`: s
// of real time that each step takes at least.
Outcome playWith(const Client& client, double wait = 10.0, double pace = 0.0) {
  const auto field = *body::fieldDescription("2006");
  const host::AgentHello robot;
  const auto setup = scenario("empty-goal", field, {robot}, 3);
  WorldParams params;
  params.referee.seconds = 0.5;
  World world(params, field, *setup, 3);
  // Tests run beside one another, each as a process.
  const std::string socket = "/tmp/kelpie-stranger-" + std::to_string(::getpid());
  auto strangers = openStrangers(socket, {robot}, kLimit);
  Outcome outcome;
  if (!strangers) return outcome;
  std::thread thread(client, socket + "-red-1");
  std::vector<Agent> agents;
  addStrangers(std::move(*strangers), wait, {}, agents);
  ServerHooks hooks;
  hooks.tell = [&](const std::string& line) { outcome.lines.push_back(line); };
  hooks.beforeStep = [&](TimeUs) { sleep(pace); };
  outcome.over = Server(world, agents, nullptr, hooks).run().ok();
  outcome.seconds = world.time().seconds();
  agents.clear();
  thread.join();
  return outcome;
}

host::Connection joined(const std::string& socket, const host::AgentHello& hello = {}) {
  auto connection = host::Connection::connect(socket, {});
  std::vector<std::uint8_t> buffer;
  EXPECT_TRUE(sendMessage(*connection, MessageType::hello, hello, buffer));
  return std::move(*connection);
}

// The next step, its image read away; false at the end of the match.
bool nextStep(host::Connection& world, host::WorldStep& step) {
  std::vector<std::uint8_t> body;
  const auto type = world.receive(body);
  if (!type || *type != MessageType::step) return false;
  return decode(body.data(), body.size(), step) &&
         (!step.imagePresent || world.receive(MessageType::image, body));
}

void answer(host::Connection& world, const host::AgentReply& reply = {}) {
  std::vector<std::uint8_t> buffer;
  (void)sendMessage(world, MessageType::reply, reply, buffer);
}

// Answers so many steps and then does something else.
Client after(int steps, const std::function<void(host::Connection&)>& then) {
  return [=](const std::string& socket) {
    host::Connection world = joined(socket);
    host::WorldStep step;
    for (int i = 0; i < steps && nextStep(world, step); ++i) answer(world);
    then(world);
  };
}

void expectOneLine(const Outcome& outcome, const std::string& part) {
  EXPECT_TRUE(outcome.over);
  EXPECT_GE(outcome.seconds, 0.5);
  ASSERT_EQ(outcome.lines.size(), 1U) << outcome.said();
  EXPECT_NE(outcome.lines[0].find("agent red 1: "), std::string::npos) << outcome.said();
  EXPECT_NE(outcome.lines[0].find(part), std::string::npos) << outcome.said();
}

TEST(Stranger, OneThatAnswersPlaysToTheGoodbye) {
  int steps = 0;
  const Outcome outcome = playWith([&](const std::string& socket) {
    host::Connection world = joined(socket);
    host::WorldStep step;
    for (; nextStep(world, step); ++steps) answer(world);
  });
  EXPECT_TRUE(outcome.over);
  EXPECT_EQ(outcome.said(), "");
  EXPECT_GE(steps, kSteps - 1);
}

TEST(Stranger, OneThatNeverComesStopsNothing) {
  expectOneLine(playWith([](const std::string&) {}, 0.1), "has not come within 0.1 s");
}

TEST(Stranger, OneThatSaysNoHelloCountsAsNotThere) {
  const auto waits = [](const std::string& socket) {
    auto connection = host::Connection::connect(socket, {});
    sleep(0.5);
  };
  expectOneLine(playWith(waits, 0.1), "has come, but not said hello within 0.1 s");
}

TEST(Stranger, OneThatComesAsAnotherRobotIsTurnedAway) {
  const auto other = [](const std::string& socket) {
    host::Connection world = joined(socket, {TeamColour::blue, 2});
    host::WorldStep step;
    EXPECT_FALSE(nextStep(world, step));
  };
  const Outcome outcome = playWith(other, 0.2);
  EXPECT_TRUE(outcome.over);
  EXPECT_NE(outcome.said().find("its hello is that of blue 2"), std::string::npos);
}

TEST(Stranger, OneThatDiesIsToldAndItsRobotStands) {
  expectOneLine(playWith(after(5, [](host::Connection&) {})),
                "connection closed by the agent at 0.1 s; its robot stands");
}

TEST(Stranger, OneThatFallsSilentIsToldOnce) {
  const auto silent = [](host::Connection& world) {
    host::WorldStep step;
    while (nextStep(world, step)) {
    }
  };
  expectOneLine(playWith(after(5, silent)), "has not answered within 0.05 s");
}

TEST(Stranger, OneThatReadsNothingStopsNothing) {
  expectOneLine(playWith(after(0, [](host::Connection&) { sleep(1.0); })),
                "has not answered within 0.05 s");
}

TEST(Stranger, GarbageIsToldAndHungUpOn) {
  const auto garbage = [](host::Connection& world) {
    const std::string text = "GET / HTTP/1.1\r\nHost: world\r\n\r\n";
    for (int i = 0; i < 1000; ++i)
      if (send(world.descriptor(), text.data(), text.size(), MSG_NOSIGNAL) < 0) break;
    host::WorldStep step;
    while (nextStep(world, step)) {
    }
  };
  expectOneLine(playWith(after(5, garbage)), "bad magic");
}

TEST(Stranger, AMessageThatNeverEndsIsLate) {
  const auto half = [](host::Connection& world) {
    const auto header = host::headerBytes(MessageType::reply, 100);
    send(world.descriptor(), header.data(), header.size(), MSG_NOSIGNAL);
    sleep(1.0);
  };
  expectOneLine(playWith(after(5, half)), "has not answered within 0.05 s");
}

TEST(Stranger, AGainThatIsNotFiniteIsRefused) {
  const auto wrong = [](host::Connection& world) {
    host::AgentReply reply;
    reply.legGain = std::nan("");
    answer(world, reply);
    host::WorldStep step;
    while (nextStep(world, step)) {
    }
  };
  expectOneLine(playWith(after(5, wrong)), "its reply is refused: legGain");
}

TEST(Stranger, OneThatIsLateGetsTheNextStepWhenItHasAnsweredAndHearsOfEveryVector) {
  std::uint32_t sent = 0, done = 0;
  TimeUs before;
  double longest = 0.0;
  const auto late = [&](const std::string& socket) {
    host::Connection world = joined(socket);
    host::WorldStep step;
    for (int i = 0; nextStep(world, step); ++i) {
      longest = std::fmax(longest, (step.time - before).seconds());
      before = step.time;
      done += step.vectorsDone;
      host::AgentReply reply;
      reply.motorPower = true;
      reply.vectors.push_back({});
      reply.vectors[0].ticks = 1;
      ++sent;
      if (i == 8) sleep(3 * kLimit);
      answer(world, reply);
    }
  };
  const Outcome outcome = playWith(late, 10.0, 0.02);
  expectOneLine(outcome, "has not answered within 0.05 s");
  EXPECT_GT(longest, 0.034);  // steps that it missed
  EXPECT_GT(done, 5U);
  EXPECT_LE(sent - done, 4U);
}

TEST(Stranger, OneThatDiedMayComeAgain) {
  int steps = 0;
  const auto twice = [&](const std::string& socket) {
    std::optional<host::Connection> first(joined(socket));
    host::Connection world = joined(socket);
    host::WorldStep step;
    for (int i = 0; i < 5 && nextStep(*first, step); ++i) answer(*first);
    first.reset();
    for (; nextStep(world, step); ++steps) answer(world);
  };
  const Outcome outcome = playWith(twice);
  EXPECT_TRUE(outcome.over);
  EXPECT_NE(outcome.said().find("agent red 1: is there"), std::string::npos) << outcome.said();
  EXPECT_GT(steps, 5);
}

}  // namespace
}  // namespace kelpie::sim
