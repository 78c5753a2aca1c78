// SPDX-License-Identifier: Apache-2.0
#include "tools/web/Guard.h"

#include <arpa/inet.h>

#include <algorithm>

namespace kelpie::web {
namespace {

// "[::1]:8765" and "localhost:8765" without port and brackets.
std::string nameIn(const std::string& host) {
  if (!host.empty() && host.front() == '[') {
    const auto end = host.find(']');
    return end == std::string::npos ? std::string() : host.substr(1, end - 1);
  }
  return host.substr(0, host.find(':'));
}

bool isAddress(const std::string& name) {
  in6_addr bytes{};
  return inet_pton(AF_INET, name.c_str(), &bytes) == 1 ||
         inet_pton(AF_INET6, name.c_str(), &bytes) == 1;
}

}  // namespace

bool Guard::isHost(const std::string& host) const {
  const std::string name = nameIn(host);
  return !name.empty() && (name == "localhost" || name == listens || isAddress(name));
}

bool Guard::isOrigin(const std::string& origin, const std::string& host) const {
  if (origin.empty() || origin == "http://" + host) return true;
  return std::find(origins.begin(), origins.end(), origin) != origins.end();
}

}  // namespace kelpie::web
