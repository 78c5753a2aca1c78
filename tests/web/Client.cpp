// SPDX-License-Identifier: Apache-2.0
#include "tests/web/Client.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

namespace kelpie::web {
namespace {

constexpr timeval kPatience{10, 0};
constexpr std::uint8_t kClose = 8;
constexpr std::uint8_t kPong = 10;

}  // namespace

Client::Client(std::uint16_t port, int buffer) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
  if (buffer > 0) setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &buffer, sizeof buffer);
  setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &kPatience, sizeof kPatience);
  setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &kPatience, sizeof kPatience);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(port);
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(connect(socket_, reinterpret_cast<sockaddr*>(&place), sizeof place), 0);
}

Client::Client(Client&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)), heard_(std::move(other.heard_)) {}

Client::~Client() {
  if (socket_ >= 0) close(socket_);
}

bool Client::send(const std::string& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t sent = ::send(socket_, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
    if (sent <= 0) return false;
    done += static_cast<std::size_t>(sent);
  }
  return true;
}

void Client::finish() { shutdown(socket_, SHUT_WR); }

bool Client::more() {
  std::array<char, 65536> buffer{};
  const ssize_t got = recv(socket_, buffer.data(), buffer.size(), 0);
  const bool waited = got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK);
  EXPECT_FALSE(waited) << "nothing came, and nobody closed";
  if (got > 0) heard_.append(buffer.data(), static_cast<std::size_t>(got));
  return got > 0;
}

std::string Client::until(const std::string& mark) {
  std::size_t found = std::string::npos;
  do {
    if (!mark.empty()) found = heard_.find(mark);
  } while (found == std::string::npos && more());
  const std::size_t end = found == std::string::npos ? heard_.size() : found + mark.size();
  const std::string text = heard_.substr(0, end);
  heard_.erase(0, end);
  return text;
}

std::string Client::bytes(std::size_t count) {
  while (heard_.size() < count && more()) {
  }
  const std::string text = heard_.substr(0, count);
  heard_.erase(0, text.size());
  return text;
}

std::string Client::upgrade(const std::string& path, const std::string& more) {
  send("GET " + path +
       " HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
       "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
       more + "\r\n");
  return until("\r\n\r\n");
}

// The mask is 0, which leaves the content as it is.
bool Client::sayFrame(std::uint8_t opcode, const std::string& content) {
  std::string frame(1, static_cast<char>(0x80 | opcode));
  const std::size_t size = content.size();
  if (size < 126) frame += static_cast<char>(0x80 | size);
  if (size >= 126) {
    frame += static_cast<char>(0x80 | 127);
    for (int i = 7; i >= 0; --i) frame += static_cast<char>(size >> (8 * i) & 0xFF);
  }
  return send(frame + std::string(4, '\0') + content);
}

std::string Client::frame() {
  const std::string head = bytes(2);
  if (head.size() < 2) return {};
  std::size_t size = static_cast<std::uint8_t>(head[1]);
  const std::size_t extra = size == 126 ? 2 : size == 127 ? 8 : 0;
  if (extra > 0) size = 0;
  for (const char c : bytes(extra)) size = size << 8 | static_cast<std::uint8_t>(c);
  const std::string content = bytes(size);
  const int opcode = head[0] & 0x0F;
  if (opcode == kClose) return {};
  return opcode == kPong || opcode == 9 ? frame() : content;
}

Heard heardFrom(const std::string& answer) {
  Heard heard;
  const auto end = answer.find("\r\n\r\n");
  if (end == std::string::npos || answer.compare(0, 9, "HTTP/1.1 ") != 0) return heard;
  heard.status = std::stoi(answer.substr(9, 3));
  heard.head = answer.substr(0, end + 2);
  heard.body = answer.substr(end + 4);
  return heard;
}

Heard ask(std::uint16_t port, const std::string& request, const std::string& more,
          const std::string& body) {
  Client client(port);
  const std::string host = more.find("Host:") == std::string::npos ? "Host: localhost\r\n" : "";
  const std::string length =
      body.empty() ? "" : "Content-Length: " + std::to_string(body.size()) + "\r\n";
  client.send(request + " HTTP/1.1\r\n" + host + "Connection: close\r\n" + length + more + "\r\n" +
              body);
  return heardFrom(client.rest());
}

}  // namespace kelpie::web
