// SPDX-License-Identifier: Apache-2.0
// A connection that has become a WebSocket. What it says waits in a queue; a peer that stops
// reading for too long, or has far too much to read, is hung up on, and its room decides what is
// said to it until then.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

#include "tools/web/Shared.h"

namespace kelpie::web {

// Whether the request names that subprotocol among those that it can speak.
bool offers(const boost::beast::http::request<boost::beast::http::string_body>& request,
            const std::string& protocol);
void enterRoom(boost::asio::ip::tcp::socket socket,
               boost::beast::http::request<boost::beast::http::string_body> request, Room& room,
               Shared& shared);

}  // namespace kelpie::web
