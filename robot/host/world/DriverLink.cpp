// SPDX-License-Identifier: Apache-2.0
#include "robot/host/world/DriverLink.h"

#include <utility>

#include "robot/host/world/Messages.h"

namespace kelpie::host {

Expected<DriverLink> DriverLink::connect(const std::string& path) {
  ConnectionParams params;
  params.peer = "the driver";
  auto connection = Connection::connect(path, params);
  if (!connection) return Error{connection.error()};
  return DriverLink(std::move(*connection));
}

DriverLink::DriverLink(Connection connection) : connection_(std::move(connection)) {}

Status DriverLink::tell(const FrameInput& input, const FrameOutput& output) {
  view_->time = input.time;
  view_->motion = input.motion;
  view_->command = output.command;
  view_->ball = output.percepts.ball;
  view_->image = input.image;
  drive_ = {true, {}};
  const Status sent = sendMessage(connection_, MessageType::view, *view_, body_);
  if (!sent) return sent;
  Drive answer;
  const Status got = receiveMessage(connection_, MessageType::drive, answer, body_);
  if (got) drive_ = answer;
  return got;
}

}  // namespace kelpie::host
