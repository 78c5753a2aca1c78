// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/world/OrderDesk.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <utility>

namespace kelpie::sim {

OrderDesk::OrderDesk(int input, World& world, Pace& pace, const body::FieldDescription& field,
                     std::vector<host::AgentHello> robots, Tell tell)
    : input_(input),
      world_(world),
      pace_(pace),
      field_(field),
      robots_(std::move(robots)),
      tell_(std::move(tell)) {}

void OrderDesk::hear() {
  pollfd wanted{input_, POLLIN, 0};
  std::array<char, 4096> buffer{};
  while (input_ >= 0 && poll(&wanted, 1, 0) > 0) {
    const ssize_t got = read(input_, buffer.data(), buffer.size());
    if (got <= 0) input_ = -1;  // nobody orders any more
    if (got > 0) pending_.append(buffer.data(), static_cast<std::size_t>(got));
  }
  for (auto end = pending_.find('\n'); end != std::string::npos; end = pending_.find('\n')) {
    obey(pending_.substr(0, end));
    pending_.erase(0, end + 1);
  }
}

void OrderDesk::obey(const std::string& line) {
  const auto order = liveOrderFrom(line);
  const Status checked = order ? checkOrder(field_, robots_, *order) : Status(Error{order.error()});
  if (!checked) return tell_(checked.error());
  obey(*order);
}

void OrderDesk::obey(const LiveOrder& order) {
  switch (order.kind) {
    case LiveOrder::Kind::pause: return pace_.pause();
    case LiveOrder::Kind::resume: return pace_.resume();
    case LiveOrder::Kind::step: return pace_.step(order.images);
    case LiveOrder::Kind::speed: return pace_.setSpeed(order.speed);
    case LiveOrder::Kind::ball: return world_.interventions().putBall(world_.time(), order.ball);
    case LiveOrder::Kind::carry:
      return world_.interventions().carry(
          {world_.time().seconds(), order.place.robot, order.place.pose});
  }
}

}  // namespace kelpie::sim
