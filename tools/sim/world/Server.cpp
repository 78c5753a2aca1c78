// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/world/Server.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "robot/core/fields/Encoding.h"

namespace kelpie::sim {
namespace {

constexpr std::int64_t kMessageUs = kTickUs * kTicksPerMessage;

std::string titleOf(const host::AgentHello& hello) { return "agent " + nameOf(hello); }

// Its number, or agents.size().
std::size_t placeOf(const host::AgentHello& hello, const std::vector<Agent>& agents) {
  const auto same = [&](const Agent& a) {
    return a.hello.team == hello.team && a.hello.player == hello.player;
  };
  return static_cast<std::size_t>(std::find_if(agents.begin(), agents.end(), same) -
                                  agents.begin());
}

std::size_t cores() { return std::max(1U, std::thread::hardware_concurrency()); }

bool before(const Agent& a, const Agent& b) {
  return a.hello.team != b.hello.team ? a.hello.team < b.hello.team
                                      : a.hello.player < b.hello.player;
}

}  // namespace

Expected<Agent> nextAgent(host::Listener& listener, double seconds) {
  host::ConnectionParams params;
  params.peer = "the agent";
  auto connection = listener.accept(seconds, params);
  if (!connection) return Error{connection.error()};
  std::vector<std::uint8_t> body;
  const Status got = connection->receive(host::MessageType::hello, body);
  if (!got) return Error{got.error()};
  host::AgentHello hello;
  std::string why;
  if (!decode(body.data(), body.size(), hello) || !verify(hello, &why))
    return Error{"an agent's hello does not say a team and a player 1 to 4"};
  return Agent{std::move(*connection), hello};
}

Expected<std::vector<Agent>> gatherAgents(host::Listener& listener, std::size_t count,
                                          double seconds, const std::function<bool()>& stopped) {
  constexpr double kPatience = 0.1;  // s
  std::vector<Agent> agents;
  while (agents.size() < count) {
    double left = seconds;
    for (; left > kPatience && !listener.isCalled(kPatience); left -= kPatience)
      if (stopped && stopped()) return Error{"stopped before all agents were there"};
    auto agent = nextAgent(listener, left);
    if (!agent) return Error{agent.error()};
    if (placeOf(agent->hello, agents) < agents.size())
      return Error{titleOf(agent->hello) + " is there twice"};
    agents.push_back(std::move(*agent));
  }
  std::sort(agents.begin(), agents.end(), before);
  return agents;
}

Expected<std::vector<Agent>> openStrangers(const std::string& socket,
                                           const std::vector<host::AgentHello>& robots,
                                           double limit) {
  std::vector<Agent> strangers;
  for (const host::AgentHello& robot : robots) {
    std::string name = nameOf(robot);
    std::replace(name.begin(), name.end(), ' ', '-');
    auto place = Stranger::open(socket + "-" + name, robot, limit);
    if (!place) return Error{place.error()};
    Agent agent{host::Connection(-1, {}), robot};
    agent.stranger = std::make_unique<Stranger>(std::move(*place));
    strangers.push_back(std::move(agent));
  }
  return strangers;
}

void addStrangers(std::vector<Agent> strangers, double seconds,
                  const std::function<bool()>& stopped, std::vector<Agent>& agents) {
  constexpr double kPatience = 0.02;  // s, for each
  const auto isMissing = [](const Agent& agent) { return !agent.stranger->present(); };
  const auto begun = std::chrono::steady_clock::now();
  const auto waited = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  };
  while (std::any_of(strangers.begin(), strangers.end(), isMissing) && waited() < seconds &&
         !(stopped && stopped()))
    for (Agent& agent : strangers) agent.stranger->look(kPatience);
  for (Agent& agent : strangers) {
    agent.stranger->absent(seconds);
    agents.push_back(std::move(agent));
  }
  std::sort(agents.begin(), agents.end(), before);
}

Server::Server(World& world, std::vector<Agent>& agents, LogWriter* log, ServerHooks hooks)
    : world_(world), agents_(agents), log_(log), hooks_(std::move(hooks)), pool_(cores()) {
  for (std::size_t i = 0; i < agents_.size(); ++i) outboxes_.push_back(std::make_unique<Outbox>());
}

std::string Server::nameOf(std::size_t robot) const { return titleOf(agents_[robot].hello); }

Server::Step Server::nextStep() const {
  const TimeUs sensorsAt{messages_ * kMessageUs};
  const TimeUs imageAt{images_ * 1000000 / 30};
  const TimeUs now = std::min(sensorsAt, imageAt);
  Step step;
  step.now = now;
  step.sensors = sensorsAt == now;
  step.image = imageAt == now;
  return step;
}

Status Server::moveTo(TimeUs now) {
  while (static_cast<std::int64_t>(world_.ticks()) * kTickUs < now.us) {
    const Status ticked = world_.tick();
    if (!ticked) return ticked;
  }
  return Done{};
}

// The world is where it is at that time.
void Server::prepare(Step step) {
  host::WorldStep out;
  out.time = step.now;
  out.sensorsPresent = step.sensors;
  out.imagePresent = step.image;
  out.control = net::packetOf(world_.control());
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    if (step.sensors) {
      out.firstTick = static_cast<std::uint32_t>(step.now.us / kTickUs) - kTicksPerMessage;
      for (std::size_t tick = 0; tick < kTicksPerMessage; ++tick)
        out.sensors[tick] = host::rawOf(world_.sensors(i)[tick]);
      out.batteryCurrent = world_.batteryCurrent(i);
      out.batteryCharge = world_.batteryCharge(i);
      out.vectorsDone = takeVectorsDone(i);
    }
    out.packets = world_.takePackets(i);
    encode(out, step.messages.emplace_back());
  }
  if (step.image) exposed_ = world_.past();
  writeTruth(step.now, step.image);
  messages_ += step.sensors ? 1 : 0;
  images_ += step.image ? 1 : 0;
  over_ = world_.finished();
  open_.push_back(std::move(step));
}

// One that is late is told when it gets steps again, for it may count those under way.
std::uint32_t Server::takeVectorsDone(std::size_t robot) {
  std::uint32_t done = world_.bodies().takeVectorsDone(robot);
  if (!agents_[robot].stranger) return done;
  Stranger& stranger = *agents_[robot].stranger;
  done += std::exchange(stranger.vectorsDone, 0);
  if (!stranger.takesSteps()) stranger.vectorsDone = done;
  return done;
}

// To the next image, unless bodies need an answer before. Steps on the way are prepared.
Status Server::moveAhead() {
  while (!over_) {
    const auto sensed =
        std::find_if(open_.begin(), open_.end(), [](const Step& step) { return step.sensors; });
    const TimeUs next = nextStep().now;
    const std::int64_t ticks = (next.us + kTickUs - 1) / kTickUs;
    if (sensed != open_.end() && ticks * kTickUs > sensed->now.us + kMessageUs) return Done{};
    const Status moved = moveTo(next);
    if (!moved || nextStep().image) return moved;
    prepare(nextStep());
  }
  return Done{};
}

// Who gets it: from here on whoever is lost or comes changes nothing of that.
void Server::begin(Step& step) {
  if (hooks_.beforeStep) hooks_.beforeStep(step.now);
  for (const Agent& agent : agents_) {
    step.lives.push_back(agent.takesSteps() ? agent.lifeNow() : kNobody);
    if (agent.stranger && agent.takesSteps()) agent.stranger->owe();
  }
  step.sent.assign(agents_.size(), Done{});
}

Status Server::sendTo(std::size_t robot, const Step& step) {
  if (step.lives[robot] == kNobody) return Done{};
  host::Connection& connection = agents_[robot].connection;
  Stranger* const stranger = agents_[robot].stranger.get();
  const std::vector<std::uint8_t>& message = step.messages[robot];
  if (stranger != nullptr) stranger->send(host::MessageType::step, message);
  if (!step.image && stranger != nullptr) return Done{};
  if (!step.image) return connection.send(host::MessageType::step, message);
  Outbox& out = *outboxes_[robot];
  world_.render(robot, exposed_, step.now, out.image);
  out.buffer.resize(encodedSize(out.image));  // the same each time, so that nothing is cleared
  encodeTo(out.image, out.buffer.data());
  if (stranger != nullptr) {
    stranger->send(host::MessageType::image, out.buffer);
    return Done{};
  }
  return connection.send(host::MessageType::step, message, host::MessageType::image, out.buffer);
}

// Images go on being rendered until the pool has finished; all else is said at once.
void Server::send(Step& step) {
  const auto one = [this, &step](std::size_t i) { step.sent[i] = sendTo(i, step); };
  if (step.image) return pool_.begin(agents_.size(), one);
  for (std::size_t i = 0; i < agents_.size(); ++i) one(i);
}

Status Server::takeReply(std::size_t robot) {
  const Status got = agents_[robot].connection.receive(host::MessageType::reply, buffer_);
  if (!got) return got;
  host::AgentReply reply;
  if (!decode(buffer_.data(), buffer_.size(), reply))
    return refuse(robot, "its reply cannot be decoded");
  std::string why;
  if (!verify(reply, &why)) return refuse(robot, "its reply is refused: " + why);
  obey(robot, reply);
  return Done{};
}

void Server::obey(std::size_t robot, const host::AgentReply& reply) {
  world_.bodies().command(robot, reply);
  if (!reply.packet.bytes.empty()) world_.send(robot, reply.packet);
}

// A stranger's; no trouble of it is one of the match.
void Server::takeAnswers(std::size_t robot, const Step& step) {
  Stranger& stranger = *agents_[robot].stranger;
  stranger.hear(step.now, step.lives[robot] == stranger.life(),
                [&](const host::AgentReply& reply) { obey(robot, reply); });
  tellNews(stranger);
}

void Server::tellNews(Stranger& stranger) {
  for (const std::string& line : stranger.takeNews())
    if (hooks_.tell) hooks_.tell(line);
}

Status Server::takeReplies(const Step& step) {
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    if (agents_[i].stranger) takeAnswers(i, step);
    if (agents_[i].stranger || !agents_[i].present || agents_[i].life != step.lives[i]) continue;
    const Status got = step.sent[i] ? takeReply(i) : step.sent[i];
    const Status borne = got ? got : lose(i, got.error());
    if (!borne) return borne;
  }
  return Done{};
}

// One that talks nonsense is hung up on, so that it ends.
Status Server::refuse(std::size_t robot, const std::string& why) {
  agents_[robot].connection.hangUp();
  if (hooks_.arrival && hooks_.tell) hooks_.tell(nameOf(robot) + ": " + why);
  return Error{why};
}

// Whoever started an agent reports that it has died; here it is reported when it is there again.
Status Server::lose(std::size_t robot, const std::string& why) {
  if (!hooks_.arrival) return Error{nameOf(robot) + ": " + why};
  agents_[robot].present = false;
  agents_[robot].lost = why;
  return Done{};
}

bool Server::takesPlace(Agent& agent) {
  const std::size_t robot = placeOf(agent.hello, agents_);
  if (robot == agents_.size() || agents_[robot].present || agents_[robot].stranger) return false;
  const int life = agents_[robot].life + 1;
  const std::string lost = std::move(agents_[robot].lost);
  agents_[robot] = std::move(agent);
  agents_[robot].life = life;
  world_.bodies().takeVectorsDone(robot);  // those of the agent before
  if (hooks_.tell) hooks_.tell(nameOf(robot) + " is there again; " + lost);
  return true;
}

// Whoever comes takes the place of one who is gone. One that is started at once comes before it is
// known here that the one before it has died, and waits for that; anybody else is sent away.
void Server::welcome() {
  while (auto agent = hooks_.arrival()) waiting_.push_back({std::move(*agent)});
  const auto leaves = [this](Arrival& one) { return takesPlace(one.agent) || --one.tries == 0; };
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), leaves), waiting_.end());
}

void Server::lookForStrangers() {
  for (const Agent& agent : agents_) {
    if (!agent.stranger) continue;
    agent.stranger->look(0.0);
    tellNews(*agent.stranger);
  }
}

// For a stranger nobody waits.
bool Server::isAnybodyThere() const {
  return std::any_of(agents_.begin(), agents_.end(),
                     [](const Agent& a) { return a.present || a.stranger; });
}

// With nobody there a match would be over before the first agent has started again.
void Server::waitForSomebody() {
  constexpr int kMax = 3000;  // half a minute
  welcome();
  for (int i = 0; i < kMax && !isAnybodyThere() && !ends(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    welcome();
  }
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
  for (Agent& agent : agents_) {
    if (!agent.stranger) {
      (void)agent.connection.send(host::MessageType::goodbye, buffer_);
      continue;
    }
    agent.stranger->send(host::MessageType::goodbye, buffer_);
    const auto lateness = agent.stranger->lateness();
    if (lateness && hooks_.tell) hooks_.tell(*lateness);
  }
}

bool Server::ends() const { return over_ || (hooks_.stopped && hooks_.stopped()); }

bool Server::isThere(const Step& step) const {
  return static_cast<std::int64_t>(world_.ticks()) * kTickUs >= step.now.us;
}

// Nothing is being sent: who comes may take a place.
Status Server::startNext() {
  if (hooks_.arrival) waitForSomebody();
  lookForStrangers();
  if (hooks_.hear) hooks_.hear();
  const Status moved = moveTo(nextStep().now);
  if (!moved) return moved;
  prepare(nextStep());
  Step& step = open_.back();
  begin(step);
  send(step);
  return Done{};
}

// While a step is rendered and sent, the bodies move to the next image. That one is begun before
// the answers to the steps ahead of it are taken, at the same time of the world, so that no core
// waits for the slowest agent: 13 % of two were idle in a fast match.
Status Server::playOn() {
  over_ = world_.finished();
  while (!ends() || !open_.empty()) {
    const Status started = open_.empty() ? startNext() : Status{Done{}};
    const Status ahead = started ? moveAhead() : started;
    if (!ahead) return ahead;
    pool_.finish();
    for (std::size_t i = 1; i < open_.size(); ++i) {  // no images
      begin(open_[i]);
      send(open_[i]);
    }
    const std::size_t sent = open_.size();
    const Status next = !ends() && isThere(nextStep()) ? startNext() : Status{Done{}};
    if (!next) return next;
    for (std::size_t i = 0; i < sent; ++i, open_.pop_front()) {
      const Status got = takeReplies(open_.front());
      if (!got) return got;
    }
  }
  return Done{};
}

Status Server::run() {
  if (log_ != nullptr && world_.isRandomised())
    log_->write(kRandomisedTopic, TimeUs{}, world_.randomised());
  const Status played = playOn();
  pool_.finish();
  writeTruth(world_.time(), false);  // what happened after the last step
  sayGoodbye(played ? 0 : 1);
  return played;
}

}  // namespace kelpie::sim
