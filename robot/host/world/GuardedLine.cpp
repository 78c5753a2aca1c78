// SPDX-License-Identifier: Apache-2.0
#include "robot/host/world/GuardedLine.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <utility>

namespace kelpie::host {
namespace {

using Clock = std::chrono::steady_clock;

// Bytes that another thread could not send wait no longer than that for this one to send them.
constexpr double kLookAround = 0.02;  // s

double secondsUntil(Clock::time_point then) {
  return std::chrono::duration<double>(then - Clock::now()).count();
}

}  // namespace

void GuardedLine::send(MessageType type, const std::vector<std::uint8_t>& body) {
  const auto header = headerBytes(type, body.size());
  {
    const std::lock_guard<std::mutex> lock(sending_);
    outgoing_.insert(outgoing_.end(), header.begin(), header.end());
    outgoing_.insert(outgoing_.end(), body.begin(), body.end());
  }
  flush();
}

// After an error nothing will ever be sent; whoever receives hears of it.
bool GuardedLine::flush() {
  const std::lock_guard<std::mutex> lock(sending_);
  std::size_t done = 0;
  while (done < outgoing_.size()) {
    const ssize_t put = ::send(connection_.descriptor(), outgoing_.data() + done,
                               outgoing_.size() - done, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0 && errno != EAGAIN && errno != EWOULDBLOCK) done = outgoing_.size();
    if (put < 0) break;
    done += static_cast<std::size_t>(put);
  }
  outgoing_.erase(outgoing_.begin(), outgoing_.begin() + static_cast<std::ptrdiff_t>(done));
  return !outgoing_.empty();
}

// What has come of the message at hand; false: the other end is gone.
bool GuardedLine::readOn() {
  while (incoming_.size() < wanted_) {
    const std::size_t before = incoming_.size();
    incoming_.resize(wanted_);
    const ssize_t got =
        recv(connection_.descriptor(), incoming_.data() + before, wanted_ - before, MSG_DONTWAIT);
    incoming_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return errno == EAGAIN || errno == EWOULDBLOCK;
    if (got == 0) return false;
  }
  return true;
}

Expected<std::optional<MessageType>> GuardedLine::take(std::vector<std::uint8_t>& body) {
  const Error gone{"connection closed by " + connection_.params().peer};
  if (!readOn()) return gone;
  if (incoming_.size() < wanted_) return std::optional<MessageType>();
  const auto header = readHeader(incoming_.data(), connection_.params());
  if (!header) return Error{header.error()};
  wanted_ = kHeaderBytes + header->size;
  if (!readOn()) return gone;
  if (incoming_.size() < wanted_) return std::optional<MessageType>();
  body.assign(incoming_.begin() + kHeaderBytes, incoming_.end());
  incoming_.clear();
  wanted_ = kHeaderBytes;
  return std::optional<MessageType>(header->type);
}

Expected<std::optional<MessageType>> GuardedLine::receive(std::vector<std::uint8_t>& body,
                                                          double seconds) {
  const auto until = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(seconds));
  for (;;) {
    const bool sends = flush();
    auto message = take(body);
    if (!message || *message) return message;
    const double left = std::min(secondsUntil(until), kLookAround);
    if (left <= 0.0) return message;
    pollfd wanted{connection_.descriptor(), static_cast<short>(sends ? POLLIN | POLLOUT : POLLIN),
                  0};
    poll(&wanted, 1, 1 + static_cast<int>(left * 1000.0));
  }
}

}  // namespace kelpie::host
