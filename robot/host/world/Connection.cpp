// SPDX-License-Identifier: Apache-2.0
// Framed messages over a Unix-domain stream socket. Time-outs are those of the kernel
// (SO_RCVTIMEO), so that no clock is read here; they count from the last byte that moved.
#include "robot/host/world/Connection.h"

#include <sys/socket.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

namespace kelpie::host {
namespace {

constexpr auto kLastType = MessageType::drive;

std::string decimal(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string hex(std::uint32_t value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08x", value);
  return text;
}

void put32(std::uint8_t* bytes, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) bytes[i] = static_cast<std::uint8_t>(value >> (8 * i));
}

std::uint32_t get32(const std::uint8_t* bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(bytes[i]) << (8 * i);
  return value;
}

void setTimeout(int descriptor, double seconds) {
  const double whole = std::floor(seconds);
  timeval limit{};
  limit.tv_sec = static_cast<decltype(limit.tv_sec)>(whole);
  limit.tv_usec = static_cast<decltype(limit.tv_usec)>((seconds - whole) * 1e6);
  setsockopt(descriptor, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
  setsockopt(descriptor, SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
}

// As many bytes as the socket takes of all parts, in one call.
template <class Part>
ssize_t writeParts(int descriptor, const Part* parts, std::size_t count) {
  std::array<iovec, 4> pieces{};
  msghdr message{};
  message.msg_iov = pieces.data();
  message.msg_iovlen = std::min(count, pieces.size());
  for (std::size_t i = 0; i < message.msg_iovlen; ++i)
    pieces[i] = {const_cast<std::uint8_t*>(parts[i].bytes), parts[i].size};
  return sendmsg(descriptor, &message, MSG_NOSIGNAL);
}

Error silence(const ConnectionParams& params) {
  return {params.peer + " has been silent for " + decimal(params.timeout) + " s"};
}

}  // namespace

Expected<MessageHeader> readHeader(const std::uint8_t* bytes, const ConnectionParams& params) {
  MessageHeader header;
  header.magic = get32(bytes);
  const std::uint32_t type = get32(bytes + 4);
  header.size = get32(bytes + 8);
  if (header.magic != kWorldMagic) {
    return Error{"bad magic " + hex(header.magic) + " from " + params.peer};
  }
  if (type > static_cast<std::uint32_t>(kLastType)) {
    return Error{"unknown message type " + std::to_string(type) + " from " + params.peer};
  }
  header.type = static_cast<MessageType>(type);
  if (header.size > params.maxBody) {
    return Error{std::string(messageName(header.type)) + " message of " +
                 std::to_string(header.size) + " bytes from " + params.peer + ", at most " +
                 std::to_string(params.maxBody) + " allowed"};
  }
  return header;
}

HeaderBytes headerBytes(MessageType type, std::size_t size) {
  HeaderBytes header;
  put32(header.data(), kWorldMagic);
  put32(header.data() + 4, static_cast<std::uint32_t>(type));
  put32(header.data() + 8, static_cast<std::uint32_t>(size));
  return header;
}

const char* messageName(MessageType type) {
  switch (type) {
    case MessageType::hello: return "hello";
    case MessageType::step: return "step";
    case MessageType::image: return "image";
    case MessageType::reply: return "reply";
    case MessageType::goodbye: return "goodbye";
    case MessageType::view: return "view";
    case MessageType::drive: return "drive";
  }
  return "unknown";
}

Connection::Connection(int descriptor, ConnectionParams params)
    : descriptor_(descriptor), params_(std::move(params)) {
  setTimeout(descriptor_, params_.timeout);
}

Connection::~Connection() {
  if (descriptor_ >= 0) close(descriptor_);
}

Connection::Connection(Connection&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), params_(std::move(other.params_)) {}

Connection& Connection::operator=(Connection&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(params_, other.params_);
  return *this;
}

Expected<HeaderBytes> Connection::headerOf(MessageType type, std::size_t size) const {
  if (size > params_.maxBody) {
    return Error{std::string(messageName(type)) + " message of " + std::to_string(size) +
                 " bytes is above the limit of " + std::to_string(params_.maxBody)};
  }
  return headerBytes(type, size);
}

void Connection::hangUp() { ::shutdown(descriptor_, SHUT_RDWR); }

Status Connection::send(MessageType type, const std::vector<std::uint8_t>& body) {
  const auto header = headerOf(type, body.size());
  if (!header) return Error{header.error()};
  std::array<Part, 2> parts{{{header->data(), header->size()}, {body.data(), body.size()}}};
  return writeAll(parts.data(), parts.size());
}

Status Connection::send(MessageType first, const std::vector<std::uint8_t>& firstBody,
                        MessageType second, const std::vector<std::uint8_t>& secondBody) {
  const auto one = headerOf(first, firstBody.size());
  if (!one) return Error{one.error()};
  const auto two = headerOf(second, secondBody.size());
  if (!two) return Error{two.error()};
  std::array<Part, 4> parts{{{one->data(), one->size()},
                             {firstBody.data(), firstBody.size()},
                             {two->data(), two->size()},
                             {secondBody.data(), secondBody.size()}}};
  return writeAll(parts.data(), parts.size());
}

Expected<MessageType> Connection::receive(std::vector<std::uint8_t>& body) {
  std::uint8_t bytes[kHeaderBytes];
  const Status headerRead = readAll(bytes, sizeof bytes, false);
  if (!headerRead) return Error{headerRead.error()};
  const Expected<MessageHeader> header = readHeader(bytes, params_);
  if (!header) return Error{header.error()};
  body.resize(header->size);
  const Status bodyRead = readAll(body.data(), body.size(), true);
  if (!bodyRead) return Error{bodyRead.error()};
  return header->type;
}

Status Connection::receive(MessageType wanted, std::vector<std::uint8_t>& body) {
  const Expected<MessageType> type = receive(body);
  if (!type) return Error{type.error()};
  if (*type != wanted) {
    return Error{std::string(messageName(*type)) + " message from " + params_.peer + " where " +
                 messageName(wanted) + " was expected"};
  }
  return Done{};
}

Status Connection::readAll(std::uint8_t* bytes, std::size_t size, bool midMessage) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t got = recv(descriptor_, bytes + done, size - done, 0);
    // A peer that dies with unread messages resets the connection instead of ending it.
    const bool closed = got == 0 || (got < 0 && errno == ECONNRESET);
    if (got > 0) {
      done += static_cast<std::size_t>(got);
    } else if (closed) {
      const bool inside = midMessage || done > 0;
      return Error{"connection closed by " + params_.peer +
                   (inside ? " in the middle of a message (" + std::to_string(done) + " of " +
                                 std::to_string(size) + " bytes)"
                           : std::string())};
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      return silence(params_);
    } else if (errno != EINTR) {
      return Error{"cannot read from " + params_.peer + ": " + std::strerror(errno)};
    }
  }
  return Done{};
}

Status Connection::writeAll(Part* parts, std::size_t count) {
  while (count > 0) {
    if (parts->size == 0) {
      ++parts;
      --count;
      continue;
    }
    const ssize_t put = writeParts(descriptor_, parts, count);
    if (put >= 0) {
      auto written = static_cast<std::size_t>(put);
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t here = std::min(written, parts[i].size);
        parts[i] = {parts[i].bytes + here, parts[i].size - here};
        written -= here;
      }
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      return silence(params_);
    } else if (errno == EPIPE || errno == ECONNRESET) {
      return Error{"connection closed by " + params_.peer};
    } else if (errno != EINTR) {
      return Error{"cannot write to " + params_.peer + ": " + std::strerror(errno)};
    }
  }
  return Done{};
}

}  // namespace kelpie::host
