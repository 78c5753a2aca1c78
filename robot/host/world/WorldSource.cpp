// SPDX-License-Identifier: Apache-2.0
#include "robot/host/world/WorldSource.h"

#include <cmath>
#include <cstdio>

#include "robot/host/world/Messages.h"

namespace kelpie::host {

Expected<WorldSource> WorldSource::connect(const std::string& path, const AgentHello& hello,
                                           const ConnectionParams& params) {
  Expected<Connection> connection = Connection::connect(path, params);
  if (!connection) return Error{"world socket: " + connection.error()};
  return join(std::move(*connection), hello);
}

Expected<WorldSource> WorldSource::join(Connection connection, const AgentHello& hello) {
  WorldSource source(std::move(connection));
  const Status sent = sendMessage(source.connection_, MessageType::hello, hello, source.body_);
  if (!sent) return source.error(sent.error());
  return source;
}

Expected<bool> WorldSource::next(WorldEvent& event) {
  const Expected<MessageType> type = connection_.receive(body_);
  if (!type) return error(type.error());
  if (*type == MessageType::step) return readStep(event);
  if (*type != MessageType::goodbye) {
    return error(std::string(messageName(*type)) + " message where step or goodbye was expected");
  }
  Goodbye goodbye;
  const Status read = readBody(*type, body_, goodbye);
  if (!read) return error(read.error());
  return false;
}

Expected<bool> WorldSource::readStep(WorldEvent& event) {
  const Status read = readBody(MessageType::step, body_, event.step);
  if (!read) return error(read.error());
  if (event.step.time < time_) return error("the time of a step runs backwards");
  time_ = event.step.time;
  if (!std::isfinite(event.step.batteryCurrent))
    return error("the battery's current is not finite");
  if (!std::isfinite(event.step.batteryCharge)) return error("the battery's charge is not finite");
  if (!event.step.imagePresent) return true;
  const Status image = receiveMessage(connection_, MessageType::image, event.image, imageBody_);
  if (!image) return error(image.error());
  return true;
}

Status WorldSource::reply(const AgentReply& reply) {
  const Status sent = sendMessage(connection_, MessageType::reply, reply, body_);
  if (!sent) return error(sent.error());
  return Done{};
}

Error WorldSource::error(const std::string& what) const {
  char time[32];
  std::snprintf(time, sizeof time, " at %.3f s", time_.seconds());
  return {"world socket: " + what + time};
}

}  // namespace kelpie::host
