// SPDX-License-Identifier: Apache-2.0
// WebSockets: who may open one, what may be said, and who is waited for.
#include "tests/web/Served.h"

namespace kelpie::web {
namespace {

class WebSocketOfOurs : public Served {
 protected:
  Client inside() {
    Client client(port());
    EXPECT_NE(client.upgrade("/room", kOffer).find("101 Switching"), std::string::npos);
    EXPECT_EQ(client.frame(), "welcome");
    return client;
  }
  int statusOf(const std::string& path, const std::string& more) const {
    Client client(port());
    return heardFrom(client.upgrade(path, more)).status;
  }
};

TEST_F(WebSocketOfOurs, IsOpenedWithItsProtocolAndEchoes) {
  Client client(port());
  const std::string head = client.upgrade("/room", "Sec-WebSocket-Protocol: other, echo.v1\r\n");
  EXPECT_NE(head.find("Sec-WebSocket-Protocol: echo.v1\r\n"), std::string::npos) << head;
  // RFC 6455, 1.3, has the same key and what follows from it.
  EXPECT_NE(head.find("s3pPLMBiTxaQ9kYGzzhZRbK+xOo="), std::string::npos) << head;
  EXPECT_EQ(client.frame(), "welcome");
  client.sayText("one");
  client.sayText("two");
  EXPECT_EQ(client.frame(), "echo one");
  EXPECT_EQ(client.frame(), "echo two");
}

TEST_F(WebSocketOfOurs, IsRefusedWithoutItsProtocol) {
  EXPECT_EQ(statusOf("/room", ""), 400);
  EXPECT_EQ(statusOf("/room", "Sec-WebSocket-Protocol: echo.v2, xecho.v1\r\n"), 400);
  EXPECT_EQ(statusOf("/room", "Sec-WebSocket-Protocol: ,  ,\r\n"), 400);
  EXPECT_EQ(site_.room.present, 0U);
}

TEST_F(WebSocketOfOurs, IsRefusedToOtherPagesAndElsewhere) {
  EXPECT_EQ(statusOf("/room", std::string(kOffer) + "Origin: http://evil.example\r\n"), 403);
  EXPECT_EQ(statusOf("/room", std::string(kOffer) + "Origin: null\r\n"), 403);
  EXPECT_EQ(statusOf("/room", std::string(kOffer) + "Origin: http://localhost\r\n"), 101);
  EXPECT_EQ(statusOf("/elsewhere", kOffer), 404);
}

TEST_F(WebSocketOfOurs, WhoLeavesIsForgotten) {
  {
    const Client first = inside();
    const Client second = inside();
    EXPECT_TRUE(becomes([this] { return site_.room.present == 2; }));
  }
  EXPECT_TRUE(becomes([this] { return site_.room.present == 0; }));
  for (int i = 0; i < 50; ++i) inside();
  EXPECT_TRUE(becomes([this] { return site_.room.present == 0; }));
}

TEST_F(WebSocketOfOurs, WhoComesWhenAllPlacesAreTakenIsSentAwayUntilSomebodyLeaves) {
  std::vector<Client> all;
  for (int i = 0; i < 8; ++i) all.push_back(inside());
  EXPECT_EQ(ask(port(), "GET /page").status, 503);
  EXPECT_EQ(statusOf("/room", kOffer), 503);
  all.pop_back();
  EXPECT_TRUE(becomes([this] { return ask(port(), "GET /page").status == 200; }));
}

TEST_F(WebSocketOfOurs, AMessageThatIsTooLongEndsItsSpeakerAlone) {
  Client other = inside();
  Client client = inside();
  client.sayText(std::string(100000, 'm'));
  EXPECT_EQ(client.frame().size(), 100005U);
  client.sayText(std::string(100001, 'm'));
  EXPECT_EQ(client.frame(), "");
  other.sayText("still here");
  EXPECT_EQ(other.frame(), "echo still here");
}

TEST_F(WebSocketOfOurs, ALengthThatNobodyHasEndsItsSpeakerAlone) {
  Client client = inside();
  client.send(std::string("\x81\xFF\x7F\xFF\xFF\xFF\xFF\xFF\xFF\xFF\0\0\0\0", 14));
  EXPECT_EQ(client.frame(), "");
  expectAnswers();
}

TEST_F(WebSocketOfOurs, NonsenseInFramesEndsItsSpeakerAlone) {
  for (const std::string& bytes :
       {std::string(20, '\xFF'), std::string("\x81\x05hello"),  // without a mask
        std::string("\x83\x80\0\0\0\0", 6), std::string("\x81\x81\0\0\0\0\xFF", 7)}) {
    Client client = inside();
    client.send(bytes);
    EXPECT_EQ(client.frame(), "");
  }
  expectAnswers();
}

TEST_F(WebSocketOfOurs, BinaryMessagesAreNotHeard) {
  Client client = inside();
  client.sayFrame(2, "bytes");
  client.sayText("text");
  EXPECT_EQ(client.frame(), "echo text");
}

TEST_F(WebSocketOfOurs, WhoNeverReadsHoldsNobodyUp) {
  Client deaf(port(), 4096);
  deaf.upgrade("/room", kOffer);
  Client reader = inside();
  chats_ = true;
  std::size_t heard = 0;
  for (int i = 0; i < 200; ++i) heard += reader.frame().size();
  EXPECT_EQ(heard, 200 * news_->size());
  EXPECT_LE(site_.room.most, EchoRoom::kMax + news_->size());
  expectAnswers();
}

// Answers must not pile up for somebody who asks on and on and takes none.
TEST_F(WebSocketOfOurs, WhoSpeaksAndNeverReadsIsNotHeardForever) {
  Client deaf(port(), 4096);
  deaf.upgrade("/room", kOffer);
  const std::string question(90000, 'q');
  bool heard = true;
  for (int i = 0; i < 1000 && heard; ++i) heard = deaf.sayText(question);
  EXPECT_FALSE(heard);
  expectAnswers();
}

}  // namespace
}  // namespace kelpie::web
