// SPDX-License-Identifier: Apache-2.0
// Sends and receives the structs of WorldProtocol.h as whole messages, for both ends.
#pragma once

#include <string>
#include <vector>

#include "robot/core/fields/Encoding.h"
#include "robot/host/world/Connection.h"

namespace kelpie::host {

// The buffer's memory is used again from message to message.
template <class T>
Status sendMessage(Connection& connection, MessageType type, const T& value,
                   std::vector<std::uint8_t>& buffer) {
  buffer.clear();
  encode(value, buffer);
  return connection.send(type, buffer);
}

// Reads the body of a message that has arrived.
template <class T>
Status readBody(MessageType type, const std::vector<std::uint8_t>& body, T& value) {
  if (decode(body.data(), body.size(), value)) return Done{};
  return Error{std::string(messageName(type)) + " message with a body of " +
               std::to_string(body.size()) + " bytes that cannot be read"};
}

template <class T>
Status receiveMessage(Connection& connection, MessageType type, T& value,
                      std::vector<std::uint8_t>& buffer) {
  const Status received = connection.receive(type, buffer);
  return received ? readBody(type, buffer, value) : received;
}

}  // namespace kelpie::host
