// SPDX-License-Identifier: Apache-2.0
// What an endpoint for datagrams is asked (openr.md 5.7; numbers of operations and errors: SDK
// headers). A buffer must lie in memory that is shared with the network. One Send and one Receive
// may be under way.
#pragma once

#include "IPAddress.h"
#include "antEnvMsg.h"

enum UDPEndpointError {
  UDP_SUCCESS = 0,
  UDP_FAIL = 1,
  UDP_CONNECTION_CLOSED = 2,
  UDP_CONNECTION_BUSY = 3,
  UDP_ADDRESSINUSE = 4,
  UDP_ADDRESSERROR = 5,
  UDP_MESSAGE_TOO_LONG = 10,
  UDP_BUFFER_INVALID = 13,
  UDP_OPERATION_INVALID = 14,
  UDP_WOULDBLOCK = 16
};

enum UDPEndpointOperation {
  UDPEndpoint_Operation_Bind = 0,
  UDPEndpoint_Operation_Connect = 1,
  UDPEndpoint_Operation_Send = 2,
  UDPEndpoint_Operation_Receive = 3,
  UDPEndpoint_Operation_Close = 4
};

struct UDPEndpointBaseMsg : public antEnvMsg {
  UDPEndpointError error = UDP_FAIL;

  UDPEndpointBaseMsg() = default;
  UDPEndpointBaseMsg(antModuleRef& module, UDPEndpointOperation operation)
      : antEnvMsg(module, operation) {}
};

struct UDPEndpointBindMsg : public UDPEndpointBaseMsg {
  IPAddress address;
  Port port = IP_PORT_ANY;

  UDPEndpointBindMsg(antModuleRef& module, IPAddress at, Port number)
      : UDPEndpointBaseMsg(module, UDPEndpoint_Operation_Bind), address(at), port(number) {}
};

struct UDPEndpointSendMsg : public UDPEndpointBaseMsg {
  IPAddress address;
  Port port = IP_PORT_ANY;
  byte* buffer = nullptr;
  int size = 0;

  UDPEndpointSendMsg(antModuleRef& module, IPAddress to, Port number, byte* bytes, int count)
      : UDPEndpointBaseMsg(module, UDPEndpoint_Operation_Send),
        address(to),
        port(number),
        buffer(bytes),
        size(count) {}
};

// `size`: room at first, what came in the reply. Address and port are those of who sent it.
struct UDPEndpointReceiveMsg : public UDPEndpointBaseMsg {
  IPAddress address;
  Port port = IP_PORT_ANY;
  byte* buffer = nullptr;
  int size = 0;

  UDPEndpointReceiveMsg(antModuleRef& module, byte* bytes, int room)
      : UDPEndpointBaseMsg(module, UDPEndpoint_Operation_Receive), buffer(bytes), size(room) {}
};

struct UDPEndpointCloseMsg : public UDPEndpointBaseMsg {
  bool linger = false;
  int lingerTime = 0;

  explicit UDPEndpointCloseMsg(antModuleRef& module, bool waits = false, int seconds = 0)
      : UDPEndpointBaseMsg(module, UDPEndpoint_Operation_Close),
        linger(waits),
        lingerTime(seconds) {}
};
