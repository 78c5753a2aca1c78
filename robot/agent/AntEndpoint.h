// SPDX-License-Identifier: Apache-2.0
// One endpoint for datagrams of the robot's network (openr.md 5.7), whatever is said over it. It is
// opened where it begins, by calls that wait for their answers. From then on it never waits:
// whatever it wants of the network it asks by a message, goes on when the answer comes, and gives
// up when none has come for a while. While it is open one Receive is always under way, one Send at
// most. It tries again some seconds after it could not be opened, was closed, or was left without
// an answer. Nothing of it ever holds up a robot whose joints move.
//
// ANT lets every message be sent or called. Public programs for the robot send Receive, Send and
// Close, and call for memory, endpoint and port, at their start: so does this. That a network
// answers when it is sent for memory, endpoint or port has not been seen on a robot; only what is
// opened again, or was not opened at the start, depends on it.
#pragma once

#include <UDPEndpointMsg.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "robot/core/Time.h"

namespace kelpie::agent {

// The object that the endpoint works for, and the entries that it gets its answers at: those to a
// Send at `sent`, all others at `heard`.
struct AntOwner {
  OID object;
  antStackRef stack;
  Selector heard = UNDEF;
  Selector sent = UNDEF;
};

struct AntEndpointParams {
  Port port = IP_PORT_ANY;
  std::size_t longest = 0;     // bytes of a datagram
  double retrySeconds = 2.0;   // from a failure to the next attempt
  double answerSeconds = 1.0;  // none for so long, but to a Receive: the network is gone
};

// What was heard lies in the endpoint until it is made to listen again.
struct Heard {
  const byte* bytes = nullptr;
  std::size_t size = 0;
};

class AntEndpoint {
 public:
  explicit AntEndpoint(const AntEndpointParams& params) : params_(params) {}

  // Opens, or fails to, before it returns: only for where the robot may wait.
  void begin(const AntOwner& owner, TimeUs now);
  // Begins to open when it is time to, and gives up what has no answer.
  void tick(TimeUs now);
  bool open() const { return state_ == State::open; }

  // An answer at the entry of that name: a datagram, or nothing when it was an error, a step of
  // opening or closing, or meant for an endpoint that was closed since.
  Heard heard(void* answer);
  void listen();
  // To everybody at this port. False: not open, too long, or the one before is still under way.
  bool broadcast(const byte* bytes, std::size_t size);
  void sent(void* answer);

 private:
  // Closed, or what it waits for: memory, an endpoint, its port, datagrams, its end. In this order,
  // but without the memory when it has that; from a failure it goes to the end of what there is.
  enum class State : std::uint8_t { closed, buffers, endpoint, binding, open, closing };
  static constexpr std::size_t kStates = 6;
  // An answer that comes so many openings late, two minutes, would be taken for a new one.
  static constexpr std::size_t kLives = 64;

  void start();
  // The request of the step of opening that it is at, if it is at one: `ask` sends or calls it.
  template <class Ask>
  void request(const Ask& ask);
  void sendRequest();
  // The answer to what it waits for, however that was asked; it enters the next state.
  void taken(antEnvMsg& answer);
  void takenMemory(antEnvCreateSharedBufferMsg& answer);
  void takenEndpoint(const antEnvCreateEndpointMsg& answer);
  void takenPort(const UDPEndpointBindMsg& answer);
  Heard takenDatagram(const UDPEndpointReceiveMsg& answer);
  void giveBack(antEnvMsg& unused);

  void enter(State state);
  void enterNext();
  bool opening() const;
  bool waits() const;
  void giveUp(const char* what, int error);
  void close();
  // An error that leaves the endpoint as good as it was.
  static bool passes(UDPEndpointError error);
  void* mark() { return &marks_[life_][static_cast<std::size_t>(state_)]; }
  bool wasOf(State state, const antEnvMsg& answer);
  template <class Message>
  antError post(Message& message, void* mark, Selector entry);
  template <class Message>
  void send(Message& message, Selector entry);
  template <class Message>
  void call(Message& message);

  AntEndpointParams params_;
  AntOwner owner_;
  antSharedBuffer in_;
  antSharedBuffer out_;
  antModuleRef module_;
  // The place of its life and state travels with each message and back: so an answer to what is not
  // waited for any more is known.
  std::array<std::array<char, kStates>, kLives> marks_{};
  std::size_t life_ = 0;
  State state_ = State::closed;
  std::size_t mapped_ = 0;  // of the two buffers
  bool sending_ = false;
  bool reported_ = false;  // of the failure that lasts: once is enough
  TimeUs now_;
  TimeUs tryAt_;
  TimeUs askedAt_;
};

}  // namespace kelpie::agent
