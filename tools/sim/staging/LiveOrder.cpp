// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/staging/LiveOrder.h"

#include <fmt/core.h>

#include "robot/core/NumberText.h"

namespace kelpie::sim {
namespace {

using Kind = LiveOrder::Kind;

Expected<LiveOrder> stepFrom(const std::string& text, LiveOrder order) {
  const auto images = numberFrom<int>(text);
  if (!images || *images < 1 || *images > kMaxStep)
    return Error{fmt::format("'step {}': a step has 1 to {} images", text, kMaxStep)};
  order.images = *images;
  return order;
}

Expected<LiveOrder> speedFrom(const std::string& text, LiveOrder order) {
  const auto speed = numberFrom<double>(text);
  if (!speed || !(*speed >= 0.0 && *speed <= kMaxSpeed))
    return Error{
        fmt::format("'speed {}': a speed is 0 to {:g} times the clock's", text, kMaxSpeed)};
  order.speed = *speed;
  return order;
}

}  // namespace

Expected<LiveOrder> liveOrderFrom(const std::string& line) {
  const auto space = line.find(' ');
  const std::string word = line.substr(0, space);
  const std::string rest = space == std::string::npos ? "" : line.substr(space + 1);
  LiveOrder order;
  if (line == "pause") return order;
  order.kind = Kind::resume;
  if (line == "resume") return order;
  order.kind = Kind::step;
  if (word == "step") return stepFrom(rest, order);
  order.kind = Kind::speed;
  if (word == "speed") return speedFrom(rest, order);
  if (word == "ball") {
    const auto ball = ballFrom(rest);
    if (!ball) return Error{ball.error()};
    order.kind = Kind::ball;
    order.ball = ball->position;
    return order;
  }
  if (word != "carry") return Error{"'" + line + "': no such order"};
  const auto place = placeFrom(rest);
  if (!place) return Error{place.error()};
  order.kind = Kind::carry;
  order.place = *place;
  return order;
}

std::string wordsFor(const LiveOrder& order) {
  switch (order.kind) {
    case Kind::pause: return "pause";
    case Kind::resume: return "resume";
    case Kind::step: return fmt::format("step {}", order.images);
    case Kind::speed: return fmt::format("speed {}", order.speed);
    case Kind::ball: return fmt::format("ball {},{}", order.ball.x, order.ball.y);
    case Kind::carry: break;
  }
  return "carry " + wordsFor(order.place);
}

Status checkOrder(const body::FieldDescription& field, const std::vector<host::AgentHello>& robots,
                  const LiveOrder& order) {
  if (order.kind == Kind::ball) return checkBall(field, {order.ball, {}});
  if (order.kind != Kind::carry) return Done{};
  return checkCarry(field, robots, {0.0, order.place.robot, order.place.pose});
}

}  // namespace kelpie::sim
