// SPDX-License-Identifier: Apache-2.0
// A simulated world behind a Unix-domain socket as the source of events. Everything that is wrong
// with the socket or a message becomes one line: "world socket: connection closed by the world at
// 12.345 s", with the time of the last step.
#pragma once

#include <string>
#include <vector>

#include "robot/host/Source.h"
#include "robot/host/world/Connection.h"

namespace kelpie::host {

class WorldSource : public Source {
 public:
  // Joins the world that listens, or will soon, at the path.
  static Expected<WorldSource> connect(const std::string& path, const AgentHello& hello,
                                       const ConnectionParams& params);
  // Takes over a connection; the hello is sent here, too.
  static Expected<WorldSource> join(Connection connection, const AgentHello& hello);

  Expected<bool> next(WorldEvent& event) override;
  Status reply(const AgentReply& reply) override;

 private:
  explicit WorldSource(Connection connection) : connection_(std::move(connection)) {}
  Expected<bool> readStep(WorldEvent& event);
  Error error(const std::string& what) const;

  Connection connection_;
  std::vector<std::uint8_t> body_;       // of the message at hand; its memory is used again
  std::vector<std::uint8_t> imageBody_;  // of images, so that it keeps their size
  TimeUs time_;
};

}  // namespace kelpie::host
