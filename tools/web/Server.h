// SPDX-License-Identifier: Apache-2.0
// A web server for a page of ours and for viewers of others: HTTP/1.1 with ranges, and WebSockets,
// from one thread. Who asks too much, too slowly, too often or from elsewhere is refused, and
// nothing of that reaches the rest of the program. Fails where the address is taken.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "robot/core/Expected.h"
#include "tools/web/ServerParams.h"
#include "tools/web/Site.h"

namespace kelpie::web {

class Server {
 public:
  // `site` must outlive the server.
  static Expected<Server> open(const ServerParams& params, Site& site);
  Server(Server&& other) noexcept;
  Server& operator=(Server&&) = delete;
  ~Server();

  std::uint16_t port() const;
  std::string url() const;  // "http://127.0.0.1:8765"
  // Serves until stop(), and calls `work` in between, so often.
  void run(double seconds, const std::function<void()>& work);
  // From any thread.
  void stop();

 private:
  struct Parts;
  explicit Server(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace kelpie::web
