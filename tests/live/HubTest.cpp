// SPDX-License-Identifier: Apache-2.0
// Foxglove's protocol as its specification words it (ws-protocol, docs/spec.md).
#include <gtest/gtest.h>

#include <cstring>

#include "tests/live/FakePeer.h"
#include "tools/live/Base64.h"
#include "tools/live/Hub.h"

namespace kelpie::live {
namespace {

const ReadyType kText{"ours/Kind", "ros1msg", "float64 x\n", "ros1"};
const ReadyType kBytes{"foxglove.Log", "protobuf", std::string("\0\1\xFF", 3), "protobuf"};
const ReadyType kLines{"kelpie.Line", "jsonschema", "{}", "json"};

class LiveHub : public testing::Test {
 protected:
  void publish(const std::string& topic, std::int64_t us, const std::string& bytes) {
    hub.publish(topic, TimeUs{us}, bytes.data(), bytes.size());
  }
  Hub hub{"kelpie", 77};
  FakePeer peer;
};

TEST_F(LiveHub, TellsWhoEntersWhatServerItIsAndWhatItOffers) {
  hub.offer("/a", kText, false);
  hub.offer("/b", kBytes, false);
  hub.offer("/c", kLines, false);
  hub.enter(peer);
  ASSERT_EQ(peer.texts.size(), 2U);
  const auto& server = peer.texts[0];
  EXPECT_EQ(server.at("op"), "serverInfo");
  EXPECT_EQ(server.at("name"), "kelpie");
  EXPECT_TRUE(server.at("capabilities").is_array());
  EXPECT_EQ(server.at("sessionId"), "77");
  EXPECT_EQ(peer.texts[1].at("op"), "advertise");
  const auto& channels = peer.texts[1].at("channels");
  EXPECT_EQ(channels[0], nlohmann::json({{"id", 0},
                                         {"topic", "/a"},
                                         {"encoding", "ros1"},
                                         {"schemaName", "ours/Kind"},
                                         {"schema", "float64 x\n"},
                                         {"schemaEncoding", "ros1msg"}}));
  EXPECT_EQ(channels[1].at("schema"), base64(kBytes.schema));
  EXPECT_EQ(channels[2].at("schema"), "{}");  // only what is no text goes out in base 64
}

TEST_F(LiveHub, TellsWhoIsThereOfANewTopicOnce) {
  hub.enter(peer);
  EXPECT_TRUE(peer.texts[1].at("channels").empty());
  hub.offer("/a", kText, false);
  hub.offer("/a", kBytes, true);
  ASSERT_EQ(peer.said("advertise").size(), 2U);
  EXPECT_EQ(peer.topics(), std::vector<std::string>{"/a"});
  EXPECT_TRUE(hub.isOffered("/a"));
  EXPECT_FALSE(hub.isOffered("/b"));
}

// Byte by byte: opcode 1, subscription as u32 and time in nanoseconds as u64, little endian.
TEST_F(LiveHub, SendsAMessageInTheLayoutOfTheSpecification) {
  hub.offer("/a", kText, false);
  hub.enter(peer);
  hub.hear(peer, subscribing(0x04030201, 0));
  publish("/a", 0x1122334455, "xyz");
  ASSERT_EQ(peer.frames.size(), 1U);
  const std::string& frame = peer.frames[0];
  ASSERT_EQ(frame.size(), 16U);
  const std::uint64_t ns = 0x1122334455ULL * 1000;
  EXPECT_EQ(frame.substr(0, 5), std::string("\1\1\2\3\4", 5));
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(static_cast<std::uint8_t>(frame[5 + i]), ns >> (8 * i) & 0xFF) << i;
  EXPECT_EQ(frame.substr(13), "xyz");
}

TEST_F(LiveHub, SendsOnlyWhatIsSubscribedAndUntilItIsNotAnyMore) {
  hub.offer("/a", kText, false);
  hub.offer("/b", kText, false);
  hub.enter(peer);
  publish("/a", 1, "before");
  hub.hear(peer, subscribing(5, 0));
  publish("/a", 2, "wanted");
  publish("/b", 3, "not wanted");
  publish("/c", 3, "not offered");
  hub.hear(peer, R"({"op":"unsubscribe","subscriptionIds":[4,5]})");
  publish("/a", 4, "behind");
  ASSERT_EQ(peer.frames.size(), 1U);
  EXPECT_EQ(peer.frames[0].substr(13), "wanted");
}

TEST_F(LiveHub, AChannelIsSubscribedOnce) {
  hub.offer("/a", kText, true);
  publish("/a", 1, "kept");
  hub.enter(peer);
  hub.hear(peer, subscribing(5, 0));
  hub.hear(peer, subscribing(6, 0));
  EXPECT_EQ(peer.frames.size(), 1U);
  publish("/a", 2, "new");
  EXPECT_EQ(peer.frames.size(), 2U);
}

TEST_F(LiveHub, SendsTheLastMessageOfATopicThatKeepsItToWhoComesLater) {
  hub.offer("/kept", kText, true);
  hub.offer("/passing", kText, false);
  publish("/kept", 1, "old");
  publish("/kept", 2, "");
  publish("/passing", 2, "gone");
  hub.enter(peer);
  hub.hear(peer, subscribing(1, 0));
  hub.hear(peer, subscribing(2, 1));
  ASSERT_EQ(peer.frames.size(), 1U);
  EXPECT_EQ(peer.frames[0].size(), 13U);
  EXPECT_EQ(peer.frames[0][5], static_cast<char>(2000 & 0xFF));
}

TEST_F(LiveHub, OfATopicThatKeepsItsLastButHasNoneNothingIsSent) {
  hub.offer("/kept", kText, true);
  hub.enter(peer);
  hub.hear(peer, subscribing(1, 0));
  EXPECT_TRUE(peer.frames.empty());
}

TEST_F(LiveHub, NonsenseIsAnsweredWithAWarningOrNothing) {
  hub.offer("/a", kText, true);
  publish("/a", 1, "kept");
  hub.enter(peer);
  const std::string deep(100000, '[');
  for (const std::string& text :
       {std::string(),
        std::string("{"),
        std::string("null"),
        std::string("[]"),
        std::string("7"),
        std::string("\"subscribe\""),
        std::string(R"({"op":7})"),
        std::string(R"({"op":"publish"})"),
        std::string(R"({"op":"subscribe"})"),
        std::string(R"({"op":"subscribe","subscriptions":7})"),
        std::string(R"({"op":"subscribe","subscriptions":null})"),
        std::string(R"({"op":"subscribe","subscriptions":{"id":1,"channelId":0}})"),
        std::string(R"({"op":"subscribe","subscriptions":[7,null,[],{}]})"),
        std::string(R"({"op":"subscribe","subscriptions":[{"id":"1","channelId":0}]})"),
        std::string(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":-1}]})"),
        std::string(R"({"op":"subscribe","subscriptions":[{"id":1.5,"channelId":0}]})"),
        std::string(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":4294967296}]})"),
        std::string(R"({"op":"subscribe","subscriptions":[{"id":4294967296,"channelId":0}]})"),
        std::string(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1}]})"),
        std::string(R"({"op":"subscribe","subscriptions":[{"id":1e999,"channelId":0}]})"),
        std::string(R"({"op":"unsubscribe"})"),
        std::string(R"({"op":"unsubscribe","subscriptionIds":{"a":[]}})"),
        std::string(R"({"op":"unsubscribe","subscriptionIds":["1",-1,null,4294967296]})"),
        std::string("\xFF\xFE{}"),
        std::string("\0", 1),
        deep,
        "{\"op\":\"subscribe\",\"subscriptions\":" + deep}) {
    hub.hear(peer, text);
    EXPECT_TRUE(peer.frames.empty()) << text.substr(0, 200);
  }
  for (const auto& status : peer.said("status")) EXPECT_EQ(status.at("level"), 1);
  EXPECT_FALSE(peer.said("status").empty());
  hub.hear(peer, subscribing(1, 0));
  EXPECT_EQ(peer.frames.size(), 1U);
}

TEST_F(LiveHub, WhoseQueueIsFullLosesMessagesAndIsToldHowMany) {
  hub.offer("/a", kText, false);
  FakePeer quick;
  for (FakePeer* const one : {&peer, &quick}) {
    hub.enter(*one);
    hub.hear(*one, subscribing(1, 0));
  }
  publish("/a", 1, "first");
  peer.waits = Hub::kMaxWaiting + 1;
  for (int i = 0; i < 5; ++i) publish("/a", 2 + i, "lost");
  EXPECT_TRUE(peer.said("status").empty());
  peer.waits = 0;
  publish("/a", 9, "last");
  publish("/a", 10, "next");
  ASSERT_EQ(peer.frames.size(), 3U);
  EXPECT_EQ(quick.frames.size(), 8U);
  ASSERT_EQ(peer.said("status").size(), 1U);
  const std::string told = peer.said("status")[0].at("message");
  EXPECT_EQ(told.substr(0, 10), "5 messages") << told;
  EXPECT_TRUE(quick.said("status").empty());
}

TEST_F(LiveHub, AfterARestartNothingOfBeforeIsOfferedAndNoNumberComesTwice) {
  hub.offer("/a", kText, true);
  publish("/a", 1, "old");
  hub.enter(peer);
  hub.hear(peer, subscribing(1, 0));
  peer.texts.clear();
  hub.restart();
  ASSERT_EQ(peer.texts.size(), 3U);
  EXPECT_EQ(peer.texts[0], nlohmann::json({{"op", "unadvertise"}, {"channelIds", {0}}}));
  EXPECT_EQ(peer.texts[1].at("op"), "serverInfo");
  EXPECT_NE(peer.texts[1].at("sessionId"), "77");
  EXPECT_FALSE(hub.isOffered("/a"));
  hub.offer("/a", kText, false);
  EXPECT_EQ(peer.channelOf("/a"), 1U);
  publish("/a", 2, "new");
  EXPECT_EQ(peer.frames.size(), 1U);  // the old subscription was of another channel
  hub.hear(peer, subscribing(1, 0));
  EXPECT_EQ(peer.said("status").size(), 1U);
  FakePeer later;
  hub.enter(later);
  EXPECT_EQ(later.topics(), std::vector<std::string>{"/a"});
  EXPECT_EQ(later.texts[1].at("channels")[0].at("id"), 1);
}

TEST_F(LiveHub, WhoHasLeftIsSpokenToNoMore) {
  hub.offer("/a", kText, false);
  hub.enter(peer);
  hub.hear(peer, subscribing(1, 0));
  EXPECT_TRUE(hub.hasPeers());
  hub.leave(peer);
  EXPECT_FALSE(hub.hasPeers());
  const std::size_t texts = peer.texts.size();
  publish("/a", 1, "late");
  hub.say("late");
  hub.restart();
  EXPECT_TRUE(peer.frames.empty());
  EXPECT_EQ(peer.texts.size(), texts);
}

TEST_F(LiveHub, ALineOfAnyBytesReachesEverybody) {
  hub.enter(peer);
  hub.say("a \xFF line");
  ASSERT_EQ(peer.said("status").size(), 1U);
  EXPECT_EQ(peer.said("status")[0].at("level"), 0);
}

}  // namespace
}  // namespace kelpie::live
