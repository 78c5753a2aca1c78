// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/AntEndpoint.h"

#include <EndpointTypes.h>
#include <OPENR/OSyslog.h>

#include <cstring>

namespace kelpie::agent {
namespace {

byte* bytesOf(antSharedBuffer& buffer) { return static_cast<byte*>(buffer.GetAddress()); }

}  // namespace

void AntEndpoint::tick(TimeUs now) {
  now_ = now;
  const bool late = waits() && (now - askedAt_).seconds() > params_.answerSeconds;
  // Why it closes was told when it began to.
  if (late && state_ == State::closing) {
    state_ = State::closed;
  } else if (late) {
    giveUp("does not answer", 0);
  }
  if (state_ == State::closed && now.us >= tryAt_.us) start();
}

void AntEndpoint::start() {
  life_ = (life_ + 1) % kLives;
  askNext();
}

void AntEndpoint::askNext() {
  if (mapped_ < 2) {
    askMemory();
  } else {
    askEndpoint();
  }
}

// Once for each of the two: the memory outlives the endpoints.
void AntEndpoint::askMemory() {
  enter(State::buffers);
  antEnvCreateSharedBufferMsg message(static_cast<uint32>(params_.longest));
  send(message, owner_.heard);
}

void AntEndpoint::shared(antEnvCreateSharedBufferMsg& answer) {
  antSharedBuffer& buffer = mapped_ == 0 ? in_ : out_;
  if (answer.error == ANT_SUCCESS) buffer = answer.buffer;
  if (answer.error != ANT_SUCCESS || buffer.Map() != ANT_SUCCESS) {
    giveBack(answer);
    giveUp("has no memory to share", answer.error);
    return;
  }
  ++mapped_;
  askNext();
}

// The pool holds two datagrams, as the documents advise.
void AntEndpoint::askEndpoint() {
  enter(State::endpoint);
  const auto pool = static_cast<int32>(2 * params_.longest);
  antEnvCreateEndpointMsg message(EndpointType_UDP, pool);
  send(message, owner_.heard);
}

void AntEndpoint::created(antEnvCreateEndpointMsg& answer) {
  if (answer.error != ANT_SUCCESS) {
    giveUp("gets no endpoint", answer.error);
    return;
  }
  module_ = answer.moduleRef;
  enter(State::binding);
  UDPEndpointBindMsg message(module_, IP_ADDR_ANY, params_.port);
  send(message, owner_.heard);
}

void AntEndpoint::bound(const UDPEndpointBindMsg& answer) {
  if (answer.error != UDP_SUCCESS) {
    giveUp("cannot be bound", answer.error);
    return;
  }
  enter(State::open);
  listen();
  if (!open()) return;
  if (told_) OSYSLOG1((osyslogINFO, "radio: port %u is open again", unsigned(params_.port)));
  told_ = false;
}

void AntEndpoint::enter(State state) {
  state_ = state;
  askedAt_ = now_;
}

// For an answer that must come soon; a datagram may never come.
bool AntEndpoint::waits() const { return open() ? sending_ : state_ != State::closed; }

void AntEndpoint::giveUp(const char* what, int error) {
  tryAt_ = {now_.us + TimeUs::fromSeconds(params_.retrySeconds).us};
  if (!told_)
    OSYSLOG1((osyslogWARNING, "radio: port %u %s: %d", unsigned(params_.port), what, error));
  told_ = true;
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

Heard AntEndpoint::heard(void* answer) {
  antEnvMsg& message = *antEnvMsg::Receive(answer);
  if (message.continuation != mark()) {
    giveBack(message);
    return {};
  }
  switch (state_) {
    case State::buffers: shared(static_cast<antEnvCreateSharedBufferMsg&>(message)); break;
    case State::endpoint: created(static_cast<antEnvCreateEndpointMsg&>(message)); break;
    case State::binding: bound(static_cast<UDPEndpointBindMsg&>(message)); break;
    case State::open: return datagram(static_cast<UDPEndpointReceiveMsg&>(message));
    case State::closing: state_ = State::closed; break;
    case State::closed: break;
  }
  return {};
}

Heard AntEndpoint::datagram(const UDPEndpointReceiveMsg& answer) {
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
