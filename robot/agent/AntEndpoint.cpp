// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/AntEndpoint.h"

#include <EndpointTypes.h>
#include <OPENR/OSyslog.h>

#include <cstring>

namespace kelpie::agent {
namespace {

bool share(const antStackRef& stack, std::size_t bytes, antSharedBuffer& buffer) {
  antEnvCreateSharedBufferMsg message(static_cast<uint32>(bytes));
  message.Call(stack, sizeof message);
  if (message.error != ANT_SUCCESS) return false;
  buffer = message.buffer;
  return buffer.Map() == ANT_SUCCESS;
}

byte* bytesOf(antSharedBuffer& buffer) { return static_cast<byte*>(buffer.GetAddress()); }

}  // namespace

void AntEndpoint::tick(TimeUs now) {
  now_ = now;
  if (open_ && sending_ && (now - sentAt_).seconds() > params_.sentSeconds) {
    close();
    fail("does not answer", 0);
  }
  if (open_ || now.us < tryAt_.us) return;
  if (!allocate() || !bind()) return;
  open_ = true;
  listen();
  if (!open_) return;
  if (told_) OSYSLOG1((osyslogINFO, "radio: port %u is open again", unsigned(params_.port)));
  told_ = false;
}

// Once: the memory outlives the endpoints.
bool AntEndpoint::allocate() {
  if (allocated_) return true;
  allocated_ =
      share(owner_.stack, params_.longest, in_) && share(owner_.stack, params_.longest, out_);
  if (!allocated_) fail("has no memory to share", 0);
  return allocated_;
}

// The pool holds two datagrams, as the documents advise.
bool AntEndpoint::bind() {
  const auto pool = static_cast<int32>(2 * params_.longest);
  antEnvCreateEndpointMsg create(EndpointType_UDP, pool);
  create.Call(owner_.stack, sizeof create);
  if (create.error != ANT_SUCCESS) {
    fail("gets no endpoint", create.error);
    return false;
  }
  module_ = create.moduleRef;
  UDPEndpointBindMsg message(module_, IP_ADDR_ANY, params_.port);
  message.Call(owner_.stack, sizeof message);
  if (message.error == UDP_SUCCESS) return true;
  close();
  fail("cannot be bound", message.error);
  return false;
}

void AntEndpoint::close() {
  UDPEndpointCloseMsg message(module_);
  message.Call(owner_.stack, sizeof message);
  open_ = sending_ = false;
  life_ = (life_ + 1) % lives_.size();
}

void AntEndpoint::fail(const char* what, int error) {
  tryAt_ = {now_.us + TimeUs::fromSeconds(params_.retrySeconds).us};
  if (!told_)
    OSYSLOG1((osyslogWARNING, "radio: port %u %s: %d", unsigned(params_.port), what, error));
  told_ = true;
}

bool AntEndpoint::passes(UDPEndpointError error) {
  return error == UDP_CONNECTION_BUSY || error == UDP_WOULDBLOCK || error == UDP_MESSAGE_TOO_LONG;
}

template <class Message>
Message* AntEndpoint::mine(void* answer) {
  auto* message = static_cast<Message*>(antEnvMsg::Receive(answer));
  return open_ && message->continuation == life() ? message : nullptr;
}

template <class Message>
void AntEndpoint::send(Message& message, Selector entry) {
  message.continuation = life();
  const antError error =
      message.Send(owner_.stack, owner_.object, static_cast<int32>(entry), sizeof message);
  if (error == ANT_SUCCESS) return;
  close();
  fail("takes no message", error);
}

Heard AntEndpoint::heard(void* answer) {
  const auto* message = mine<UDPEndpointReceiveMsg>(answer);
  if (message == nullptr) return {};
  if (message->error == UDP_SUCCESS && message->size > 0)
    return {bytesOf(in_), static_cast<std::size_t>(message->size)};
  if (message->error == UDP_SUCCESS || passes(message->error)) {
    listen();
    return {};
  }
  close();
  fail("is deaf", message->error);
  return {};
}

void AntEndpoint::listen() {
  if (!open_) return;
  UDPEndpointReceiveMsg message(module_, bytesOf(in_), static_cast<int>(params_.longest));
  send(message, owner_.heard);
}

bool AntEndpoint::broadcast(const byte* bytes, std::size_t size) {
  if (!open_ || sending_ || size > params_.longest) return false;
  std::memcpy(bytesOf(out_), bytes, size);
  UDPEndpointSendMsg message(module_, IP_ADDR_BROADCAST, params_.port, bytesOf(out_),
                             static_cast<int>(size));
  sending_ = true;
  sentAt_ = now_;
  send(message, owner_.sent);
  return open_;
}

void AntEndpoint::sent(void* answer) {
  const auto* message = mine<UDPEndpointSendMsg>(answer);
  if (message == nullptr) return;
  sending_ = false;
  if (message->error == UDP_SUCCESS || passes(message->error)) return;
  close();
  fail("is mute", message->error);
}

}  // namespace kelpie::agent
