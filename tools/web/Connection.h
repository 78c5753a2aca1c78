// SPDX-License-Identifier: Apache-2.0
// One connection of the web server, from its first byte to its last: requests one after the other,
// or a WebSocket. Lives as long as something of it is under way.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <memory>

#include "tools/web/Guard.h"
#include "tools/web/Server.h"

namespace kelpie::web {

// What all connections of a server have in common; outlives them.
struct Shared {
  ServerParams params;
  Guard guard;
  Site& site;
  std::size_t connections = 0;
};

void serve(boost::asio::ip::tcp::socket socket, Shared& shared);

}  // namespace kelpie::web
