// SPDX-License-Identifier: Apache-2.0
// Where a web server listens, and how much it takes from whom.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kelpie::web {

struct ServerParams {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8765;           // 0: any that is free
  std::vector<std::string> origins;    // Guard.h
  std::size_t maxConnections = 32;     // at the same time; others are sent away
  std::size_t maxBody = 1U << 20;      // bytes of a request, and of what a peer says
  std::size_t maxWaiting = 32U << 20;  // bytes that a peer has not taken yet
  double patience = 30.0;              // s for a request to come and for an answer to be taken
};

}  // namespace kelpie::web
