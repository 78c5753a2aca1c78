// SPDX-License-Identifier: Apache-2.0
// Framing and faults of the world socket.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <fstream>

#include "robot/host/world/Connection.h"

namespace kelpie::host {
namespace {

using Bytes = std::vector<std::uint8_t>;

ConnectionParams quick() {
  ConnectionParams params;
  params.timeout = 0.05;
  params.connectTimeout = 0.05;
  return params;
}

std::string socketPath(const char* name) {
  return "/tmp/kelpie-" + std::to_string(getpid()) + "-" + name;
}

void sendRaw(const Connection& end, const Bytes& bytes) {
  ASSERT_EQ(static_cast<ssize_t>(bytes.size()),
            ::send(end.descriptor(), bytes.data(), bytes.size(), MSG_NOSIGNAL));
}

// What the receiving end says about raw bytes, after which the sender hangs up if asked.
std::string complaint(const Bytes& bytes, bool hangUp) {
  auto pair = connectedPair(quick());
  sendRaw(pair->first, bytes);
  if (hangUp) ::shutdown(pair->first.descriptor(), SHUT_WR);
  Bytes body;
  return pair->second.receive(body).error();
}

const Bytes kStepOf5 = {'1', 'P', 'L', 'K', 1, 0, 0, 0, 5, 0, 0, 0};

TEST(ConnectionTest, MessageArrivesAsSent) {
  auto pair = connectedPair(quick());
  ASSERT_TRUE(pair->first.send(MessageType::image, Bytes{1, 2, 3}));
  Bytes body{9, 9, 9, 9, 9};
  const auto type = pair->second.receive(body);
  ASSERT_TRUE(type) << type.error();
  EXPECT_EQ(MessageType::image, *type);
  EXPECT_EQ((Bytes{1, 2, 3}), body);
}

TEST(ConnectionTest, HeaderIsTwelveLittleEndianBytes) {
  auto pair = connectedPair(quick());
  ASSERT_TRUE(pair->first.send(MessageType::step, Bytes{7, 7, 7, 7, 7}));
  Bytes raw(17);
  ASSERT_EQ(17, ::recv(pair->second.descriptor(), raw.data(), raw.size(), 0));
  EXPECT_EQ(kStepOf5, Bytes(raw.begin(), raw.begin() + 12));
}

TEST(ConnectionTest, CleanEndOfFileIsReportedAtOnce) {
  EXPECT_EQ("connection closed by the world", complaint({}, true));
}

TEST(ConnectionTest, EndOfFileInHeaderOrBodyIsReportedWithItsPlace) {
  EXPECT_EQ("connection closed by the world in the middle of a message (2 of 12 bytes)",
            complaint({'1', 'P'}, true));
  Bytes truncated = kStepOf5;
  truncated.push_back(0);
  EXPECT_EQ("connection closed by the world in the middle of a message (1 of 5 bytes)",
            complaint(truncated, true));
}

TEST(ConnectionTest, SilentPeerIsNoticed) {
  EXPECT_EQ("the world has been silent for 0.05 s", complaint({}, false));
  EXPECT_EQ("the world has been silent for 0.05 s", complaint(kStepOf5, false));
}

TEST(ConnectionTest, BadMagicIsRefused) {
  Bytes wrong = kStepOf5;
  wrong[0] = '2';
  EXPECT_EQ("bad magic 0x4b4c5032 from the world", complaint(wrong, false));
}

TEST(ConnectionTest, UnknownTypeIsRefused) {
  Bytes wrong = kStepOf5;
  wrong[4] = 7;
  EXPECT_EQ("unknown message type 7 from the world", complaint(wrong, false));
}

TEST(ConnectionTest, OversizeIsRefusedBeforeAnythingIsAllocated) {
  Bytes wrong = kStepOf5;
  wrong[11] = 0xff;
  EXPECT_EQ("step message of 4278190085 bytes from the world, at most 1048576 allowed",
            complaint(wrong, false));
}

TEST(ConnectionTest, OversizeIsNotSent) {
  auto pair = connectedPair(quick());
  const Status status = pair->first.send(MessageType::image, Bytes((1U << 20) + 1));
  EXPECT_EQ("image message of 1048577 bytes is above the limit of 1048576", status.error());
}

TEST(ConnectionTest, WrongTypeIsRefusedByName) {
  auto pair = connectedPair(quick());
  ASSERT_TRUE(pair->first.send(MessageType::goodbye, Bytes{}));
  Bytes body;
  EXPECT_EQ("goodbye message from the world where image was expected",
            pair->second.receive(MessageType::image, body).error());
}

TEST(ConnectionTest, WritingToAClosedPeerIsAnErrorNotASignal) {
  auto pair = connectedPair(quick());
  { const Connection gone = std::move(pair->second); }
  EXPECT_EQ("connection closed by the world", pair->first.send(MessageType::reply, {1}).error());
}

TEST(ListenerTest, AcceptsWhoConnects) {
  const std::string path = socketPath("accept");
  auto listener = Listener::open(path);
  ASSERT_TRUE(listener) << listener.error();
  auto agent = Connection::connect(path, quick());
  ASSERT_TRUE(agent) << agent.error();
  auto world = listener->accept(1.0, quick());
  ASSERT_TRUE(world) << world.error();
  ASSERT_TRUE(agent->send(MessageType::hello, {1, 2}));
  Bytes body;
  EXPECT_TRUE(world->receive(MessageType::hello, body));
}

TEST(ListenerTest, RemovesItsFile) {
  const std::string path = socketPath("remove");
  { ASSERT_TRUE(Listener::open(path)); }
  EXPECT_NE(0, access(path.c_str(), F_OK));
}

TEST(ListenerTest, ReplacesAStaleSocketFile) {
  const std::string path = socketPath("stale");
  const int left = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strcpy(address.sun_path, path.c_str());
  ASSERT_EQ(0, ::bind(left, reinterpret_cast<sockaddr*>(&address), sizeof address));
  ::close(left);
  const auto listener = Listener::open(path);
  EXPECT_TRUE(listener) << listener.error();
}

TEST(ListenerTest, RefusesAPathInUse) {
  const std::string path = socketPath("used");
  const auto first = Listener::open(path);
  const auto second = Listener::open(path);
  EXPECT_EQ(path + ": another world listens here", second.error());
  EXPECT_EQ(0, access(path.c_str(), F_OK));
}

TEST(ListenerTest, RefusesAFileThatIsNoSocket) {
  const std::string path = socketPath("file");
  std::ofstream(path) << "keep me";
  EXPECT_EQ(path + ": exists and is not a socket", Listener::open(path).error());
  EXPECT_EQ(0, unlink(path.c_str()));
}

// The system's own limit is 107 characters; people's folders of temporary files have more.
TEST(ListenerTest, AFolderOfAnyLengthHoldsASocket) {
  const std::string folder = testing::TempDir() + "/" + std::string(150, 'f');
  ASSERT_EQ(0, mkdir(folder.c_str(), 0700));
  {
    auto listener = Listener::open(folder + "/world");
    ASSERT_TRUE(listener) << listener.error();
    EXPECT_TRUE(Connection::connect(folder + "/world", quick()));
    EXPECT_TRUE(listener->accept(1.0, quick()));
    EXPECT_EQ(folder + "/world: another world listens here",
              Listener::open(folder + "/world").error());
  }
  EXPECT_EQ(0, rmdir(folder.c_str())) << "nothing is left in it";
  EXPECT_FALSE(Listener::open(folder + "/world")) << "the folder is gone";
}

TEST(ListenerTest, WaitsOnlyAsLongAsAsked) {
  auto listener = Listener::open(socketPath("nobody"));
  EXPECT_FALSE(listener->accept(0.01, quick()));
}

TEST(ListenerTest, ConnectingToNobodyIsOneClearLine) {
  EXPECT_EQ("/tmp/kelpie-nobody-there: cannot connect: No such file or directory",
            Connection::connect("/tmp/kelpie-nobody-there", quick()).error());
  EXPECT_NE(std::string::npos,
            Connection::connect(std::string(200, 'x'), quick()).error().find("200 characters"));
}

}  // namespace
}  // namespace kelpie::host
