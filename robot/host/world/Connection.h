// SPDX-License-Identifier: Apache-2.0
// One end of a Unix-domain stream socket that carries the messages of WorldProtocol.h, for the
// agent and for the world. Reading is strict: a wrong magic, an unknown type, a body above the
// limit, an end of file and a silent peer are each one clear line. After an error the connection is
// of no use.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/host/world/WorldProtocol.h"

namespace kelpie::host {

struct ConnectionParams {
  double timeout = 60.0;             // s without a byte until the peer counts as dead; 0 = for ever
  double connectTimeout = 10.0;      // s that connect waits for a world that is not listening yet
  std::uint32_t maxBody = 1U << 20;  // bytes; the largest message, an image, has 99 840
  std::string peer = "the world";    // how the other end is called in errors
};

constexpr std::size_t kHeaderBytes = 12;
using HeaderBytes = std::array<std::uint8_t, kHeaderBytes>;

// A message's header as it is sent, and back; an error is one line.
HeaderBytes headerBytes(MessageType type, std::size_t size);
Expected<MessageHeader> readHeader(const std::uint8_t* bytes, const ConnectionParams& params);

class Connection {
 public:
  // Waits until somebody listens at the path, at most connectTimeout.
  static Expected<Connection> connect(const std::string& path, const ConnectionParams& params);
  // Takes over a connected stream socket.
  Connection(int descriptor, ConnectionParams params);
  ~Connection();
  Connection(Connection&& other) noexcept;
  Connection& operator=(Connection&& other) noexcept;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  Status send(MessageType type, const std::vector<std::uint8_t>& body);
  // Two in one system call: each call wakes the peer, which costs both more than the bytes do.
  Status send(MessageType first, const std::vector<std::uint8_t>& firstBody, MessageType second,
              const std::vector<std::uint8_t>& secondBody);
  // Waits for the next message; the body replaces what the vector held.
  Expected<MessageType> receive(std::vector<std::uint8_t>& body);
  // The same, and an error when the message has another type.
  Status receive(MessageType wanted, std::vector<std::uint8_t>& body);

  // Both ends hear no more of each other; the other thread may still be sending.
  void hangUp();

  int descriptor() const { return descriptor_; }
  const ConnectionParams& params() const { return params_; }

 private:
  Status readAll(std::uint8_t* bytes, std::size_t size, bool midMessage);
  // Bytes somewhere, which a call writes from there.
  struct Part {
    const std::uint8_t* bytes;
    std::size_t size;
  };
  Expected<HeaderBytes> headerOf(MessageType type, std::size_t size) const;
  // What is written is taken off the parts.
  Status writeAll(Part* parts, std::size_t count);

  int descriptor_ = -1;
  ConnectionParams params_;
};

// Two connected ends, for tests and worlds in the same process.
struct ConnectionPair {
  Connection first;
  Connection second;
};
Expected<ConnectionPair> connectedPair(const ConnectionParams& params);

// The world's side. The socket file is removed at the end; one that a dead process left is
// replaced, one that a live process serves, or a file that is no socket, is an error.
class Listener {
 public:
  static Expected<Listener> open(const std::string& path);
  ~Listener();
  Listener(Listener&& other) noexcept;
  Listener& operator=(Listener&& other) noexcept;
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  // Whether somebody is there to be accepted, within that time.
  bool isCalled(double seconds) const;
  // Waits at most `seconds` for the next agent. `params` are those of the new connection.
  Expected<Connection> accept(double seconds, const ConnectionParams& params);
  const std::string& path() const { return path_; }

 private:
  Listener(int descriptor, std::string path);

  int descriptor_ = -1;
  std::string path_;
};

const char* messageName(MessageType type);

}  // namespace kelpie::host
