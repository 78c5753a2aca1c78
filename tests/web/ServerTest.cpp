// SPDX-License-Identifier: Apache-2.0
// A server that is asked well, badly, too much and by too many.
#include "tests/web/Served.h"

namespace kelpie::web {
namespace {

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

using WebServer = Served;

TEST_F(WebServer, AFileIsAnsweredWithItsTypeAndRules) {
  const Heard heard = ask(port(), "GET /page");
  EXPECT_EQ(heard.status, 200);
  EXPECT_EQ(heard.body, "0123456789");
  for (const char* line :
       {"Content-Type: text/plain\r\n", "Content-Length: 10\r\n", "Accept-Ranges: bytes\r\n",
        "X-Content-Type-Options: nosniff\r\n", "Content-Security-Policy: default-src 'none';",
        "Cross-Origin-Resource-Policy: same-origin\r\n", "Cache-Control: no-store\r\n"})
    EXPECT_TRUE(holds(heard.head, line)) << line << heard.head;
}

TEST_F(WebServer, TheHeadAloneHasTheLengthAndNoBody) {
  const Heard heard = ask(port(), "HEAD /page");
  EXPECT_EQ(heard.status, 200);
  EXPECT_TRUE(holds(heard.head, "Content-Length: 10\r\n"));
  EXPECT_EQ(heard.body, "");
}

TEST_F(WebServer, APartOfAFileIsItsBytes) {
  const Heard part = ask(port(), "GET /page", "Range: bytes=2-4\r\n");
  EXPECT_EQ(part.status, 206);
  EXPECT_EQ(part.body, "234");
  EXPECT_TRUE(holds(part.head, "Content-Range: bytes 2-4/10\r\n")) << part.head;
  const Heard beyond = ask(port(), "GET /page", "Range: bytes=10-\r\n");
  EXPECT_EQ(beyond.status, 416);
  EXPECT_TRUE(holds(beyond.head, "Content-Range: bytes */10\r\n")) << beyond.head;
}

TEST_F(WebServer, AConnectionHearsOneRequestAfterTheOther) {
  Client client(port());
  const std::string request = "GET /page HTTP/1.1\r\nHost: localhost\r\n\r\n";
  client.send(request + request);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(heardFrom(client.until("\r\n\r\n")).status, 200);
    EXPECT_EQ(client.bytes(10), "0123456789");
  }
}

TEST_F(WebServer, AHeadThatIsTooLongIsRefused) {
  EXPECT_EQ(ask(port(), "GET /page", "A: " + std::string(20000, 'a') + "\r\n").status, 431);
  EXPECT_EQ(ask(port(), "GET /" + std::string(20000, 'a')).status, 431);
  expectAnswers();
}

TEST_F(WebServer, ABodyMayBeAsLongAsItMayAndNoLonger) {
  const std::string longest(100000, 'b');
  EXPECT_EQ(ask(port(), "POST /echo", "", longest).body, longest);
  EXPECT_EQ(ask(port(), "POST /echo", "", longest + "b").status, 413);
  EXPECT_EQ(ask(port(), "POST /echo", "", std::string(8000000, 'b')).status, 413);
  EXPECT_EQ(ask(port(), "POST /echo", "Content-Length: 18446744073709551615\r\n").status, 413);
  expectAnswers();
}

TEST_F(WebServer, ChunksThatAreTooLongTogetherAreRefused) {
  std::string chunks;
  for (int i = 0; i < 11; ++i) chunks += "2710\r\n" + std::string(10000, 'c') + "\r\n";
  Client client(port());
  client.send("POST /echo HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n" +
              chunks + "0\r\n\r\n");
  EXPECT_EQ(heardFrom(client.rest()).status, 413);
}

TEST_F(WebServer, WhatIsNoRequestIsRefused) {
  for (const std::string& bytes :
       {std::string("hello\r\n\r\n"), std::string("\0\1\2\3\r\n\r\n", 8),
        std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 11),
        std::string("GET /page HTTP/9.9\r\n\r\n"), std::string("GET /a b HTTP/1.1\r\n\r\n"),
        std::string("POST / HTTP/1.1\r\nContent-Length: x\r\n\r\n"),
        std::string("POST / HTTP/1.1\r\nContent-Length: -1\r\n\r\n")}) {
    Client client(port());
    client.send(bytes);
    EXPECT_EQ(heardFrom(client.rest()).status, 400) << bytes;
  }
  expectAnswers();
}

TEST_F(WebServer, OtherNamesAndOtherPagesAreRefused) {
  EXPECT_EQ(ask(port(), "GET /page", "Host: evil.example\r\n").status, 403);
  EXPECT_EQ(ask(port(), "GET /page", "Host: \r\n").status, 403);
  EXPECT_EQ(ask(port(), "POST /echo", "Origin: http://evil.example\r\n", "b").status, 403);
  EXPECT_EQ(ask(port(), "POST /echo", "Origin: null\r\n", "b").status, 403);
  EXPECT_EQ(ask(port(), "POST /echo", "Origin: http://localhost\r\n", "b").status, 200);
  Client old(port());
  old.send("GET /page HTTP/1.0\r\n\r\n");
  EXPECT_EQ(heardFrom(old.rest()).status, 403);
}

TEST_F(WebServer, AHundredAtOnceAreAnsweredOrSentAwayAndThenItAnswersOn) {
  std::vector<Client> clients;
  for (int i = 0; i < 100; ++i) clients.emplace_back(port());
  for (Client& client : clients)
    client.send("GET /page HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  int answered = 0, sentAway = 0;
  for (Client& client : clients) {
    const int status = heardFrom(client.rest()).status;
    answered += status == 200 ? 1 : 0;
    sentAway += status == 503 ? 1 : 0;
  }
  EXPECT_GE(answered, 1);
  EXPECT_EQ(answered + sentAway, 100);
  EXPECT_TRUE(becomes([&] { return ask(port(), "GET /page").status == 200; }));
}

TEST_F(WebServer, WhoSaysOneByteAndThenNothingIsHungUpOn) {
  Client slow(port());
  Client silent(port());
  slow.send("G");
  expectAnswers();
  EXPECT_EQ(slow.rest(), "");
  EXPECT_EQ(silent.rest(), "");
}

// Each byte alone must not earn a client new patience.
TEST_F(WebServer, WhoSaysAByteNowAndThenIsHungUpOn) {
  Client slow(port());
  bool open = slow.send("GET /page HTTP/1.1\r\n");
  int said = 0;
  for (; open && said < 500; ++said) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    open = slow.send("a");
  }
  EXPECT_LT(said, 500);
  expectAnswers();
}

TEST_F(WebServer, WhoReadsNothingOfALargeFileIsHungUpOnWhileOthersAreAnswered) {
  constexpr std::uintmax_t kLarge = 32U << 20;
  const auto large = fs::temp_directory_path() / "large";
  std::ofstream{large};
  fs::resize_file(large, kLarge);
  Client idle(port(), 4096);
  idle.send("GET /large HTTP/1.1\r\nHost: localhost\r\n\r\n");
  for (int i = 0; i < 20; ++i) expectAnswers();
  std::this_thread::sleep_for(std::chrono::milliseconds(800));
  EXPECT_LT(idle.rest().size(), kLarge);
  EXPECT_GT(ask(port(), "GET /large").body.size(), kLarge - 1);
}

TEST_F(WebServer, AFileThatIsCutOffMeanwhileEndsTheConnectionOnly) {
  const auto cut = fs::temp_directory_path() / "cut";
  std::ofstream{cut};
  fs::resize_file(cut, 32U << 20);
  Client client(port(), 4096);
  client.send("GET /cut HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_EQ(heardFrom(client.until("\r\n\r\n")).status, 200);
  fs::resize_file(cut, 10);
  EXPECT_LT(client.rest().size(), 32U << 20);
  expectAnswers();
}

TEST(Server, APortThatIsTakenAndAnAddressThatIsNoneAreErrorsOfOneLine) {
  EchoSite site;
  ServerParams params;
  params.port = 0;
  const auto first = Server::open(params, site);
  ASSERT_TRUE(first);
  params.port = first->port();
  const auto second = Server::open(params, site);
  ASSERT_FALSE(second);
  EXPECT_TRUE(holds(second.error(), "in use")) << second.error();
  for (const char* address : {"nonsense", "256.1.1.1", "", "203.0.113.1"}) {
    params.address = address;
    params.port = 0;
    EXPECT_FALSE(Server::open(params, site)) << address;
  }
}

TEST(Server, ItsUrlLeadsToIt) {
  EchoSite site;
  ServerParams params;
  params.port = 0;
  params.address = "0.0.0.0";
  const auto any = Server::open(params, site);
  ASSERT_TRUE(any);
  EXPECT_EQ(any->url(), "http://localhost:" + std::to_string(any->port()));
}

}  // namespace
}  // namespace kelpie::web
