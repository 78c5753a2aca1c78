// SPDX-License-Identifier: Apache-2.0
// What of a match's logs reaches whom, and on which topics.
#include "tests/live/Relayed.h"
#include "tools/live/Relay.h"

namespace kelpie::live {
namespace {

TEST_F(Relayed, TheStudioGetsEachRobotsTopicsUnderItsNameAndTheWorldsOnce) {
  writeRobot("a.mcap", TeamColour::red, 1);
  writeRobot("b.mcap", TeamColour::blue, 4);
  Relay both(TimeUs{}, viewers, studio);
  relay(both, "a.mcap");
  relay(both, "b.mcap");
  for (const char* topic : {"/live/red-1/config", "/live/red-1/frame/output",
                            "/live/red-1/frame/picture", "/live/blue-4/config",
                            "/live/blue-4/frame/output", "/live/world/truth", "/live/world/event"})
    EXPECT_EQ(offered(topic), 1U) << topic;
  EXPECT_EQ(page.topics().size(), 8U);
}

TEST_F(Relayed, TheWorldsTopicsComeFromOneLogOnly) {
  writeRobot("a.mcap", TeamColour::red, 1);
  Relay both(TimeUs{}, viewers, studio);
  relay(both, "a.mcap");
  studio.hear(page, subscribing(1, page.channelOf("/live/world/truth")));
  writeRobot("b.mcap", TeamColour::blue, 4);
  relay(both, "b.mcap");
  EXPECT_TRUE(page.frames.empty());
}

TEST_F(Relayed, OfALogWithoutConfigurationOnlyTheWorldIsPassedOn) {
  {
    auto log = std::move(*LogWriter::open(pathOf("world.mcap"), LogOptions{}));
    writeFrame(log, 0);
    writeTruth(log, 0);
  }
  Relay one(TimeUs{}, viewers, studio);
  relay(one, "world.mcap");
  EXPECT_EQ(page.topics(), (std::vector<std::string>{"/live/world/truth", "/live/world/event"}));
}

TEST_F(Relayed, AConfigurationIsKeptForWhoComesLater) {
  writeRobot("a.mcap", TeamColour::red, 1);
  Relay one(TimeUs{}, viewers, studio);
  relay(one, "a.mcap");
  FakePeer later;
  studio.enter(later);
  subscribeAll(studio, later);
  ASSERT_EQ(later.frames.size(), 1U);
  EXPECT_GT(later.frames[0].size(), 1000U);
}

TEST_F(Relayed, ViewersGetARobotsFramesAndTheField) {
  writeRobot("a.mcap", TeamColour::red, 1);
  Relay one(TimeUs{5000000}, viewers, studio);
  relay(one, "a.mcap");
  for (const char* topic : {"/field", "/tf", "/red1/camera"})
    EXPECT_TRUE(has(viewer.topics(), topic)) << topic;
}

TEST_F(Relayed, LateFramesReachTheStudioOnly) {
  writeRobot("a.mcap", TeamColour::red, 1);
  Relay one(TimeUs{}, viewers, studio);
  relay(one, "a.mcap", true);
  EXPECT_FALSE(has(viewer.topics(), "/red1/camera"));
  EXPECT_EQ(offered("/live/red-1/frame/output"), 1U);
}

TEST_F(Relayed, OfFramesFasterThanThePauseViewersGetOneAndTheStudioAll) {
  writeRobot("a.mcap", TeamColour::red, 1);
  for (const bool slow : {false, true}) {
    Relay one(TimeUs{}, viewers, studio, std::chrono::hours(slow ? 1 : 0));
    relay(one, "a.mcap");  // offers the topics
    viewers.hear(viewer, subscribing(1, viewer.channelOf("/red1/pose")));
    studio.hear(page, subscribing(1, page.channelOf("/live/red-1/frame/output")));
    viewer.frames.clear();
    page.frames.clear();
    relay(one, "a.mcap");
    EXPECT_EQ(viewer.frames.size(), slow ? 1U : 3U);
    EXPECT_EQ(page.frames.size(), 3U);
  }
}

TEST_F(Relayed, ARobotsSecondLogGoesOnWhereItsFirstEnded) {
  writeRobot("a.mcap", TeamColour::red, 1);
  Relay one(TimeUs{}, viewers, studio);
  relay(one, "a.mcap");
  viewer.frames.clear();
  subscribeAll(viewers, viewer);
  subscribeAll(studio, page);
  viewer.frames.clear();
  page.frames.clear();
  const std::size_t topics = page.topics().size();
  writeRobot("a-2.mcap", TeamColour::red, 1, 1000000);
  relay(one, "a-2.mcap");
  EXPECT_EQ(page.topics().size(), topics);
  EXPECT_EQ(page.frames.size(), 7U);  // configuration, three inputs and outputs; no second world
  EXPECT_FALSE(viewer.frames.empty());
}

TEST_F(Relayed, ADamagedConfigurationNamesNobody) {
  {
    auto log = std::move(*LogWriter::open(pathOf("a.mcap"), LogOptions{}));
    log.write(kConfigTopic, TimeUs{}, WalkRequest{});
    writeFrame(log, 0);
  }
  Relay one(TimeUs{}, viewers, studio);
  relay(one, "a.mcap");
  EXPECT_TRUE(page.topics().empty());
}

}  // namespace
}  // namespace kelpie::live
