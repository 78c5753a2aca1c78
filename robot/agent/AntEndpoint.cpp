// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/AntEndpoint.h"

#include <EndpointTypes.h>
#include <OPENR/OSyslog.h>

#include <cstring>

namespace kelpie::agent {
namespace {

byte* bytesOf(antSharedBuffer& buffer) { return static_cast<byte*>(buffer.GetAddress()); }

}  // namespace

void AntEndpoint::begin(const AntOwner& owner, TimeUs now) {
  owner_ = owner;
  now_ = now;
  if (state_ != State::closed) return;  // begun before
  start();
  while (opening()) request([this](auto& message) { call(message); });
}

void AntEndpoint::tick(TimeUs now) {
  now_ = now;
  const bool late = waits() && (now - askedAt_).seconds() > params_.answerSeconds;
  // Why it closes was reported when it began to.
  if (late && state_ == State::closing) {
    state_ = State::closed;
  } else if (late) {
    giveUp("does not answer", 0);
  }
  if (state_ != State::closed || now.us < tryAt_.us) return;
  start();
  sendRequest();
}

void AntEndpoint::start() {
  life_ = (life_ + 1) % kLives;
  enterNext();
}

// The memory is asked for once for each of the two, since it outlives the endpoints. The pool holds
// two datagrams, as the documents advise.
template <class Ask>
void AntEndpoint::request(const Ask& ask) {
  const auto longest = static_cast<int32>(params_.longest);
  if (state_ == State::buffers) {
    antEnvCreateSharedBufferMsg message(static_cast<uint32>(longest));
    ask(message);
  } else if (state_ == State::endpoint) {
    antEnvCreateEndpointMsg message(EndpointType_UDP, 2 * longest);
    ask(message);
  } else if (state_ == State::binding) {
    UDPEndpointBindMsg message(module_, IP_ADDR_ANY, params_.port);
    ask(message);
  }
}

void AntEndpoint::sendRequest() {
  request([this](auto& message) { send(message, owner_.heard); });
}

void AntEndpoint::taken(antEnvMsg& answer) {
  switch (state_) {
    case State::buffers: takenMemory(static_cast<antEnvCreateSharedBufferMsg&>(answer)); break;
    case State::endpoint: takenEndpoint(static_cast<antEnvCreateEndpointMsg&>(answer)); break;
    case State::binding: takenPort(static_cast<UDPEndpointBindMsg&>(answer)); break;
    case State::closing: state_ = State::closed; break;
    case State::open:
    case State::closed: break;
  }
}

void AntEndpoint::takenMemory(antEnvCreateSharedBufferMsg& answer) {
  antSharedBuffer& buffer = mapped_ == 0 ? in_ : out_;
  if (answer.error == ANT_SUCCESS) buffer = answer.buffer;
  if (answer.error != ANT_SUCCESS || buffer.Map() != ANT_SUCCESS) {
    giveBack(answer);
    giveUp("has no memory to share", answer.error);
    return;
  }
  ++mapped_;
  enterNext();
}

void AntEndpoint::takenEndpoint(const antEnvCreateEndpointMsg& answer) {
  if (answer.error != ANT_SUCCESS) {
    giveUp("gets no endpoint", answer.error);
    return;
  }
  module_ = answer.moduleRef;
  enter(State::binding);
}

void AntEndpoint::takenPort(const UDPEndpointBindMsg& answer) {
  if (answer.error != UDP_SUCCESS) {
    giveUp("cannot be bound", answer.error);
    return;
  }
  enter(State::open);
  listen();
  if (!open()) return;
  if (reported_) OSYSLOG1((osyslogINFO, "radio: port %u is open again", unsigned(params_.port)));
  reported_ = false;
}

void AntEndpoint::enter(State state) {
  state_ = state;
  askedAt_ = now_;
}

// The step after which there is memory, or an endpoint.
void AntEndpoint::enterNext() { enter(mapped_ < 2 ? State::buffers : State::endpoint); }

bool AntEndpoint::opening() const { return waits() && !open() && state_ != State::closing; }

// For an answer that must come soon; a datagram may never come.
bool AntEndpoint::waits() const { return open() ? sending_ : state_ != State::closed; }

void AntEndpoint::giveUp(const char* what, int error) {
  tryAt_ = {now_.us + TimeUs::fromSeconds(params_.retrySeconds).us};
  if (!reported_)
    OSYSLOG1((osyslogWARNING, "radio: port %u %s: %d", unsigned(params_.port), what, error));
  reported_ = true;
  if (state_ == State::binding || state_ == State::open) {
    close();
  } else {
    state_ = State::closed;
  }
}

void AntEndpoint::close() {
  enter(State::closing);
  sending_ = false;
  UDPEndpointCloseMsg message(module_);
  if (post(message, mark(), owner_.heard) != ANT_SUCCESS) state_ = State::closed;
}

bool AntEndpoint::passes(UDPEndpointError error) {
  return error == UDP_CONNECTION_BUSY || error == UDP_WOULDBLOCK || error == UDP_MESSAGE_TOO_LONG;
}

bool AntEndpoint::wasOf(State state, const antEnvMsg& answer) {
  for (auto& marks : marks_)
    if (answer.continuation == &marks[static_cast<std::size_t>(state)]) return true;
  return false;
}

template <class Message>
antError AntEndpoint::post(Message& message, void* mark, Selector entry) {
  message.continuation = mark;
  return message.Send(owner_.stack, owner_.object, static_cast<int32>(entry), sizeof message);
}

template <class Message>
void AntEndpoint::send(Message& message, Selector entry) {
  const antError error = post(message, mark(), entry);
  if (error != ANT_SUCCESS) giveUp("takes no message", error);
}

// The answer is in the message then. As in public programs nothing else is looked at: what was not
// answered still holds the failure that it was made with.
template <class Message>
void AntEndpoint::call(Message& message) {
  message.continuation = mark();
  (void)message.Call(owner_.stack, sizeof message);
  taken(message);
}

Heard AntEndpoint::heard(void* answer) {
  antEnvMsg& message = *antEnvMsg::Receive(answer);
  if (message.continuation != mark()) {
    giveBack(message);
    return {};
  }
  if (open()) return takenDatagram(static_cast<UDPEndpointReceiveMsg&>(message));
  taken(message);
  sendRequest();
  return {};
}

Heard AntEndpoint::takenDatagram(const UDPEndpointReceiveMsg& answer) {
  if (answer.error == UDP_SUCCESS && answer.size > 0)
    return {bytesOf(in_), static_cast<std::size_t>(answer.size)};
  if (answer.error == UDP_SUCCESS || passes(answer.error)) {
    listen();
  } else {
    giveUp("is deaf", answer.error);
  }
  return {};
}

// Memory or an endpoint that comes after it was given up is nobody's, and a network that is only
// slow would run out of them. Nobody waits for the answer to this.
void AntEndpoint::giveBack(antEnvMsg& unused) {
  if (wasOf(State::buffers, unused)) {
    auto& answer = static_cast<antEnvCreateSharedBufferMsg&>(unused);
    antEnvDestroySharedBufferMsg message(answer.buffer);
    if (answer.error == ANT_SUCCESS) (void)post(message, nullptr, owner_.heard);
  } else if (wasOf(State::endpoint, unused)) {
    auto& answer = static_cast<antEnvCreateEndpointMsg&>(unused);
    UDPEndpointCloseMsg message(answer.moduleRef);
    if (answer.error == ANT_SUCCESS) (void)post(message, nullptr, owner_.heard);
  }
}

void AntEndpoint::listen() {
  if (!open()) return;
  UDPEndpointReceiveMsg message(module_, bytesOf(in_), static_cast<int>(params_.longest));
  send(message, owner_.heard);
}

bool AntEndpoint::broadcast(const byte* bytes, std::size_t size) {
  if (!open() || sending_ || size > params_.longest) return false;
  std::memcpy(bytesOf(out_), bytes, size);
  UDPEndpointSendMsg message(module_, IP_ADDR_BROADCAST, params_.port, bytesOf(out_),
                             static_cast<int>(size));
  sending_ = true;
  askedAt_ = now_;
  send(message, owner_.sent);
  return open();
}

void AntEndpoint::sent(void* answer) {
  const auto& message = static_cast<UDPEndpointSendMsg&>(*antEnvMsg::Receive(answer));
  if (message.continuation != mark()) return;
  sending_ = false;
  if (message.error != UDP_SUCCESS && !passes(message.error)) giveUp("is mute", message.error);
}

}  // namespace kelpie::agent
