// SPDX-License-Identifier: Apache-2.0
// The agent's end of the world protocol, against a world at the other end of a socket pair.
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <thread>

#include "FakeWorld.h"
#include "robot/host/RunAgent.h"
#include "robot/host/world/Messages.h"
#include "robot/host/world/WorldSource.h"

namespace kelpie::host {
namespace {

using Bytes = std::vector<std::uint8_t>;

class WorldSourceTest : public testing::Test {
 protected:
  WorldSourceTest() {
    ConnectionParams params;
    params.timeout = 0.05;
    auto pair = connectedPair(params);
    world_.emplace(std::move(pair->first));
    auto source = WorldSource::join(std::move(pair->second), {TeamColour::blue, 3});
    source_.emplace(std::move(*source));
  }

  void sendStep(const WorldStep& step) {
    ASSERT_TRUE(sendMessage(*world_, MessageType::step, step, buffer_));
  }
  std::string error() { return source_->next(event_).error(); }

  std::optional<Connection> world_;
  std::optional<WorldSource> source_;
  WorldEvent event_;
  Bytes buffer_;
};

TEST_F(WorldSourceTest, SaysHelloFirst) {
  AgentHello hello;
  ASSERT_TRUE(receiveMessage(*world_, MessageType::hello, hello, buffer_));
  EXPECT_EQ(TeamColour::blue, hello.team);
  EXPECT_EQ(3, hello.player);
}

TEST_F(WorldSourceTest, StepAndImageBecomeOneEvent) {
  WorldStep step;
  step.time.us = 33333;
  step.imagePresent = true;
  step.sensors[2].sensors[openr::index(openr::Sensor::headTouch)] = 7;
  sendStep(step);
  Image image;
  image.cb.back() = 99;
  ASSERT_TRUE(sendMessage(*world_, MessageType::image, image, buffer_));
  const auto more = source_->next(event_);
  ASSERT_TRUE(more) << more.error();
  EXPECT_TRUE(*more);
  EXPECT_EQ(33333, event_.step.time.us);
  EXPECT_EQ(7, event_.step.sensors[2].of(openr::Sensor::headTouch));
  EXPECT_EQ(99, event_.image.cb.back());
}

TEST_F(WorldSourceTest, GoodbyeIsTheEnd) {
  ASSERT_TRUE(sendMessage(*world_, MessageType::goodbye, Goodbye{}, buffer_));
  const auto more = source_->next(event_);
  ASSERT_TRUE(more) << more.error();
  EXPECT_FALSE(*more);
}

TEST_F(WorldSourceTest, ClosedConnectionIsReportedWithTheTimeOfTheLastStep) {
  WorldStep step;
  step.time.us = 12345000;
  sendStep(step);
  ASSERT_TRUE(source_->next(event_));
  world_.reset();
  EXPECT_EQ("world socket: connection closed by the world at 12.345 s", error());
}

TEST_F(WorldSourceTest, ClosingInsteadOfTheImageIsReported) {
  WorldStep step;
  step.imagePresent = true;
  sendStep(step);
  ::shutdown(world_->descriptor(), SHUT_WR);
  EXPECT_EQ("world socket: connection closed by the world at 0.000 s", error());
}

TEST_F(WorldSourceTest, BodyOfWrongSizeIsRefused) {
  encode(WorldStep{}, buffer_);
  const std::size_t right = buffer_.size();
  buffer_.pop_back();
  ASSERT_TRUE(world_->send(MessageType::step, buffer_));
  EXPECT_EQ("world socket: step message with a body of " + std::to_string(right - 1) +
                " bytes that cannot be read at 0.000 s",
            error());
}

TEST_F(WorldSourceTest, TooLongBodyIsRefused) {
  encode(WorldStep{}, buffer_);
  buffer_.push_back(0);
  ASSERT_TRUE(world_->send(MessageType::step, buffer_));
  EXPECT_NE(std::string::npos, error().find("cannot be read"));
}

TEST_F(WorldSourceTest, OutOfTurnMessageIsRefused) {
  ASSERT_TRUE(sendMessage(*world_, MessageType::hello, AgentHello{}, buffer_));
  EXPECT_EQ("world socket: hello message where step or goodbye was expected at 0.000 s", error());
}

TEST_F(WorldSourceTest, TimeRunningBackwardsIsRefused) {
  WorldStep step;
  step.time.us = 2000;
  sendStep(step);
  step.time.us = 1000;
  sendStep(step);
  ASSERT_TRUE(source_->next(event_));
  EXPECT_EQ("world socket: the time of a step runs backwards at 0.002 s", error());
}

TEST_F(WorldSourceTest, NotANumberIsRefused) {
  WorldStep step;
  step.batteryCurrent = std::numeric_limits<double>::quiet_NaN();
  sendStep(step);
  EXPECT_EQ("world socket: the battery's current is not finite at 0.000 s", error());
  step.batteryCurrent = 0.0;
  step.batteryCharge = std::numeric_limits<double>::infinity();
  sendStep(step);
  EXPECT_EQ("world socket: the battery's charge is not finite at 0.000 s", error());
}

TEST_F(WorldSourceTest, SilentWorldIsNoticed) {
  EXPECT_EQ("world socket: the world has been silent for 0.05 s at 0.000 s", error());
}

// The world's side of a match: 50 lock-stepped messages, an image with each, then goodbye.
void playWorld(Connection world, std::vector<AgentReply>& replies) {
  Bytes buffer;
  AgentHello hello;
  ASSERT_TRUE(receiveMessage(world, MessageType::hello, hello, buffer));
  FakeSource script;
  script.addSensors(50);
  for (WorldStep step : script.steps) {
    step.imagePresent = true;
    ASSERT_TRUE(sendMessage(world, MessageType::step, step, buffer));
    ASSERT_TRUE(sendMessage(world, MessageType::image, script.image, buffer));
    AgentReply reply;
    ASSERT_TRUE(receiveMessage(world, MessageType::reply, reply, buffer));
    replies.push_back(reply);
  }
  ASSERT_TRUE(sendMessage(world, MessageType::goodbye, Goodbye{}, buffer));
}

TEST(WorldMatchTest, AgentAndWorldKeepStepToTheGoodbye) {
  auto pair = connectedPair({});
  std::vector<AgentReply> replies;
  std::thread world(playWorld, std::move(pair->first), std::ref(replies));
  auto source = WorldSource::join(std::move(pair->second), {});
  FakeLoops loops;
  const auto summary = runAgent(*source, loops, {}, {});
  world.join();
  ASSERT_TRUE(summary) << summary.error();
  EXPECT_EQ(50U, summary->sensorMessages);
  EXPECT_EQ(50U, summary->images);
  ASSERT_EQ(50U, replies.size());
  for (std::size_t i = 1; i < replies.size(); ++i) EXPECT_EQ(1U, replies[i].vectors.size());
}

TEST(WorldMatchTest, WorldThatDiesEndsTheAgentWithOneLine) {
  auto pair = connectedPair({});
  auto source = WorldSource::join(std::move(pair->second), {});
  { const Connection dies = std::move(pair->first); }
  FakeLoops loops;
  EXPECT_EQ("world socket: connection closed by the world at 0.000 s",
            runAgent(*source, loops, {}, {}).error());
}

}  // namespace
}  // namespace kelpie::host
