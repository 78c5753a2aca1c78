// SPDX-License-Identifier: Apache-2.0
// Who may ask: pages of this server and programs, not other pages that the same browser has open.
// A browser tells the page's origin with a WebSocket and with what changes something, and the name
// that it asked for in Host: a page elsewhere whose name is made to lead here (DNS rebinding) names
// itself there.
#pragma once

#include <string>
#include <vector>

namespace kelpie::web {

struct Guard {
  std::string listens;               // the address that the server listens at
  std::vector<std::string> origins;  // others that may ask, as "https://app.foxglove.dev"

  // An address in numbers, localhost, or the name that the server listens at; with or without port.
  bool isHost(const std::string& host) const;
  // No origin at all (a program), this server's own page, or one of `origins`.
  bool isOrigin(const std::string& origin, const std::string& host) const;
};

}  // namespace kelpie::web
