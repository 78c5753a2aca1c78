// SPDX-License-Identifier: Apache-2.0
// One endpoint for datagrams of the robot's network (openr.md 5.7), whatever is said over it. One
// Receive is always under way, one Send at most. It opens when it is told the time, and again some
// seconds after it could not be opened, was closed, or left a Send without an answer; opening waits
// for the network a few times, hence the seconds. Nothing of it ever stops the robot.
#pragma once

#include <UDPEndpointMsg.h>

#include <array>
#include <cstddef>

#include "robot/core/Time.h"

namespace kelpie::agent {

// The object that the endpoint works for, and the entries that it gets its answers at.
struct AntOwner {
  OID object;
  antStackRef stack;
  Selector heard = UNDEF;
  Selector sent = UNDEF;
};

struct AntEndpointParams {
  Port port = IP_PORT_ANY;
  std::size_t longest = 0;    // bytes of a datagram
  double retrySeconds = 2.0;  // from a failure to the next attempt
  double sentSeconds = 1.0;   // a Send without an answer for so long means that the network is gone
};

// What was heard lies in the endpoint until it is told to listen again.
struct Heard {
  const byte* bytes = nullptr;
  std::size_t size = 0;
};

class AntEndpoint {
 public:
  explicit AntEndpoint(const AntEndpointParams& params) : params_(params) {}

  void begin(const AntOwner& owner) { owner_ = owner; }
  // Opens when it is time to.
  void tick(TimeUs now);
  bool open() const { return open_; }

  // The answer to a Receive: a datagram, or nothing when it was an error or of an endpoint that was
  // closed since.
  Heard heard(void* answer);
  void listen();
  // To everybody at this port. False: not open, too long, or the one before is still under way.
  bool broadcast(const byte* bytes, std::size_t size);
  void sent(void* answer);

 private:
  bool allocate();
  bool bind();
  void close();
  void fail(const char* what, int error);
  // An error that leaves the endpoint as good as it was.
  static bool passes(UDPEndpointError error);
  void* life() { return &lives_[life_]; }
  template <class Message>
  Message* mine(void* answer);
  template <class Message>
  void send(Message& message, Selector entry);

  AntEndpointParams params_;
  AntOwner owner_;
  antSharedBuffer in_;
  antSharedBuffer out_;
  antModuleRef module_;
  // Travels with each message and back: an answer to an endpoint that was closed is not taken. One
  // that comes 64 openings late, which is two minutes, would be.
  std::array<char, 64> lives_{};
  std::size_t life_ = 0;
  bool allocated_ = false;
  bool open_ = false;
  bool sending_ = false;
  bool told_ = false;  // of the failure that lasts: once is enough
  TimeUs now_;
  TimeUs tryAt_;
  TimeUs sentAt_;
};

}  // namespace kelpie::agent
