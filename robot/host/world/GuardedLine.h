// SPDX-License-Identifier: Apache-2.0
// One end of a stream socket whose other end is not trusted, with the messages of WorldProtocol.h:
// nothing here waits longer than its caller says, however the other end sends or reads. What the
// socket does not take is kept, and goes out while somebody sends or receives; what comes is kept
// until a message is whole. One thread may send while another receives. A message that cannot be
// is one clear line, and nothing after it is read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "robot/host/world/Connection.h"

namespace kelpie::host {

class GuardedLine {
 public:
  // Takes the connection over. Of its parameters the time-out does not count.
  explicit GuardedLine(Connection connection) : connection_(std::move(connection)) {}

  // Never waits. A peer that is gone is told by receive().
  void send(MessageType type, const std::vector<std::uint8_t>& body);
  // The next message, or nothing when none is whole within so many seconds.
  Expected<std::optional<MessageType>> receive(std::vector<std::uint8_t>& body, double seconds);
  // The other end hears no more; the other thread may still be sending.
  void hangUp() { connection_.hangUp(); }

 private:
  bool flush();  // true: bytes are left
  bool readOn();
  Expected<std::optional<MessageType>> take(std::vector<std::uint8_t>& body);

  Connection connection_;
  std::mutex sending_;
  std::vector<std::uint8_t> outgoing_;
  std::vector<std::uint8_t> incoming_;  // of the message at hand
  std::size_t wanted_ = kHeaderBytes;   // bytes of it that are known to come
};

}  // namespace kelpie::host
