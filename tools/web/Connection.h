// SPDX-License-Identifier: Apache-2.0
// One connection of the web server, from its first byte to its last: requests one after the other,
// or a WebSocket. Lives as long as something of it is under way.
#pragma once

#include <boost/asio/ip/tcp.hpp>

#include "tools/web/Shared.h"

namespace kelpie::web {

void serve(boost::asio::ip::tcp::socket socket, Shared& shared);

}  // namespace kelpie::web
