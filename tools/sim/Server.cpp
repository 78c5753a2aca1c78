// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/Server.h"

#include <algorithm>
#include <utility>

#include "robot/core/Encoding.h"

namespace kelpie::sim {
namespace {

constexpr std::int64_t kMessageUs = kTickUs * kTicksPerMessage;

std::string titleOf(const host::AgentHello& hello) {
  const char* team = hello.team == TeamColour::red ? "red" : "blue";
  return std::string("agent ") + team + " " + std::to_string(hello.player);
}

bool before(const Agent& a, const Agent& b) {
  return a.hello.team != b.hello.team ? a.hello.team < b.hello.team
                                      : a.hello.player < b.hello.player;
}

}  // namespace

Expected<std::vector<Agent>> gatherAgents(host::Listener& listener, std::size_t count,
                                          double seconds) {
  std::vector<Agent> agents;
  std::vector<std::uint8_t> body;
  host::ConnectionParams params;
  params.peer = "the agent";
  while (agents.size() < count) {
    auto connection = listener.accept(seconds, params);
    if (!connection) return Error{connection.error()};
    const Status got = connection->receive(host::MessageType::hello, body);
    if (!got) return Error{got.error()};
    host::AgentHello hello;
    std::string why;
    if (!decode(body.data(), body.size(), hello) || !verify(hello, &why)) {
      return Error{"an agent's hello does not say a team and a player 1 to 4"};
    }
    for (const Agent& other : agents) {
      if (other.hello.team == hello.team && other.hello.player == hello.player) {
        return Error{titleOf(hello) + " is there twice"};
      }
    }
    agents.push_back({std::move(*connection), hello});
  }
  std::sort(agents.begin(), agents.end(), before);
  return agents;
}

Server::Server(World& world, std::vector<Agent>& agents, LogWriter* log, ServerHooks hooks)
    : world_(world),
      agents_(agents),
      log_(log),
      hooks_(std::move(hooks)),
      image_(std::make_unique<Image>()) {}

std::string Server::nameOf(std::size_t robot) const { return titleOf(agents_[robot].hello); }

Status Server::sendStep(std::size_t robot, TimeUs now, bool sensors, bool image) {
  host::WorldStep step;
  step.time = now;
  step.sensorsPresent = sensors;
  if (sensors) {
    step.firstTick = static_cast<std::uint32_t>(now.us / kTickUs) - kTicksPerMessage;
    step.sensors = world_.sensors(robot);
    step.batteryCurrent = world_.batteryCurrent(robot);
  }
  step.vectorsDone = world_.bodies().takeVectorsDone(robot);
  step.imagePresent = image;
  step.game = world_.gameFor(robot);
  buffer_.clear();
  encode(step, buffer_);
  const Status sent = agents_[robot].connection.send(host::MessageType::step, buffer_);
  if (!sent || !image) return sent;
  world_.render(robot, now, *image_);
  buffer_.clear();
  encode(*image_, buffer_);
  return agents_[robot].connection.send(host::MessageType::image, buffer_);
}

Status Server::takeReply(std::size_t robot) {
  const Status got = agents_[robot].connection.receive(host::MessageType::reply, buffer_);
  if (!got) return got;
  host::AgentReply reply;
  if (!decode(buffer_.data(), buffer_.size(), reply)) return Error{"its reply cannot be decoded"};
  std::string why;
  if (!verify(reply, &why)) return Error{"its reply is refused: " + why};
  world_.bodies().command(robot, reply);
  return Done{};
}

Status Server::step(TimeUs now, bool sensors, bool image) {
  // First all agents get their part, so that they think at the same time.
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const Status sent = sendStep(i, now, sensors, image);
    if (!sent) return Error{nameOf(i) + ": " + sent.error()};
  }
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const Status got = takeReply(i);
    if (!got) return Error{nameOf(i) + ": " + got.error()};
  }
  return Done{};
}

void Server::writeTruth(TimeUs now, bool image) {
  const std::vector<MatchEvent> events = world_.takeEvents();
  if (hooks_.onEvent)
    for (const MatchEvent& event : events) hooks_.onEvent(event);
  if (log_ == nullptr) return;
  for (const MatchEvent& event : events) log_->write(kEventTopic, event.time, event);
  if (image) log_->write(kTruthTopic, now, world_.truth(now));
}

void Server::sayGoodbye(std::uint8_t reason) {
  buffer_.clear();
  encode(host::Goodbye{reason}, buffer_);
  // The agent may be gone already: what it misses is of no use to it.
  for (Agent& agent : agents_) (void)agent.connection.send(host::MessageType::goodbye, buffer_);
}

Status Server::moveTo(TimeUs now) {
  while (static_cast<std::int64_t>(world_.ticks()) * kTickUs < now.us) {
    const Status ticked = world_.tick();
    if (!ticked) return ticked;
  }
  return Done{};
}

Status Server::run() {
  std::int64_t messages = 1;
  std::int64_t images = 1;
  if (log_ != nullptr && world_.isUnlike()) log_->write(kUnlikeTopic, TimeUs{}, world_.unlike());
  while (!world_.finished() && !(hooks_.stopped && hooks_.stopped())) {
    const std::int64_t sensorsAt = messages * kMessageUs;
    const std::int64_t imageAt = images * 1000000 / 30;
    const std::int64_t now = std::min(sensorsAt, imageAt);
    const Status moved = moveTo({now});
    if (!moved) {
      sayGoodbye(1);
      return moved;
    }
    if (hooks_.beforeStep) hooks_.beforeStep({now});
    const bool sensors = now == sensorsAt;
    const bool image = now == imageAt;
    const Status done = step({now}, sensors, image);
    writeTruth({now}, image);
    if (!done) {
      sayGoodbye(1);
      return done;
    }
    if (sensors) ++messages;
    if (image) ++images;
  }
  sayGoodbye(0);
  return Done{};
}

}  // namespace kelpie::sim
