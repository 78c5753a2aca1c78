// SPDX-License-Identifier: Apache-2.0
// kelpie-world: the simulated match as a process. Waits for its agents at a Unix socket, plays one
// match with them in lock step, writes what really happened, and ends.
#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <functional>
#include <optional>
#include <utility>

#include "robot/host/radio/UdpControl.h"
#include "tools/cli/AgentTalk.h"
#include "tools/cli/Process.h"
#include "tools/cli/options/Usage.h"
#include "tools/sim/WorldOptions.h"
#include "tools/sim/referee/UnusedControl.h"
#include "tools/sim/world/OrderDesk.h"
#include "tools/sim/world/Pace.h"
#include "tools/sim/world/Server.h"

namespace kelpie::sim {
namespace {

struct Options : WorldOptions {
  std::string socket;
  std::size_t robots = 1;
  std::vector<std::string> strangers;  // TEAM:PLAYER each
  double agentLimit = 0.5;             // s
  double agentWait = 10.0;             // s
  bool realTime = false;
  bool orders = false;  // of a person, on standard input
  bool respawn = false;
  std::uint16_t controller = 0;  // UDP port where a game controller is heard; 0: the world rules
  double wait = 60.0;            // s for the agents to come
  bool noRing = false, noNoise = false, noShift = false, noRolling = false;
  bool noBlur = false, noSpectators = false;
  bool noCentres = false, noShine = false, noOwnLegs = false;
};

WorldParams serverParams(const Options& options) {
  WorldParams params = worldParams(options);
  ArtefactParams& artefacts = params.camera.artefacts;
  artefacts.ring = !options.noRing;
  artefacts.noise = !options.noNoise;
  artefacts.shift = !options.noShift;
  artefacts.blur = !options.noBlur;
  artefacts.centres = !options.noCentres;
  params.shine.on = !options.noShine;
  params.ownLegs = !options.noOwnLegs;
  params.rolling = !options.noRolling;
  params.spectators = !options.noSpectators;
  params.referee.controlled = options.controller != 0;
  return params;
}

// Hears a game controller for the world, and says of what it makes nothing.
class ControlDesk {
 public:
  ControlDesk(host::UdpControl socket, std::uint16_t port)
      : socket_(std::move(socket)), port_(port), unused_(port) {}

  void hear(World& world) {
    ControlPacket packet;
    while (socket_.receive(packet)) take(packet, world);
  }

 private:
  void take(const ControlPacket& packet, World& world) {
    net::GameControlData control;
    const auto refusal = net::decodeControl(packet.bytes.begin(), packet.bytes.size(), control);
    if (refusal) {
      const auto line = unused_.lineFor(packet, *refusal);
      return line ? tellLine(*line) : void();
    }
    if (!heard_) tellLine(fmt::format("a game controller is heard at port {}", port_));
    heard_ = true;
    world.hear(control);
  }

  host::UdpControl socket_;
  std::uint16_t port_;
  bool heard_ = false;
  UnusedControl unused_;
};

// An agent that comes late and says no hello holds the match up for as long as a dead one does.
std::optional<Agent> arrival(host::Listener& listener) {
  auto agent = nextAgent(listener, 0.0);
  if (!agent) return std::nullopt;
  return std::move(*agent);
}

ServerHooks hooks(const Options& options, host::Listener& listener, const World& world, Pace& pace,
                  const std::function<void()>& hear) {
  ServerHooks hooks;
  if (options.respawn) hooks.arrival = [&listener] { return arrival(listener); };
  hooks.tell = tellLine;
  if (options.tellGoals) hooks.onEvent = tell;
  hooks.stopped = cli::interrupted;
  std::optional<TimeTeller> teller;
  if (options.tellTime) teller.emplace(world);
  hooks.beforeStep = [teller, &pace, hear](TimeUs now) mutable {
    if (teller) (*teller)(now);
    pace.await(now, hear, cli::interrupted);
  };
  return hooks;
}

void tellEnd(const Status& log, TimeUs when) {
  tellLine(fmt::format("{}{}{:.1f} s", log.error(), cli::kLogEndsMark, when.seconds()));
}

// A log that cannot be written any more is reported once, and the match goes on.
void watchLog(const LogWriter& log, ServerHooks& hooks) {
  hooks.beforeStep = [&log, before = hooks.beforeStep, reported = false](TimeUs now) mutable {
    before(now);
    if (reported || log.status()) return;
    reported = true;
    tellEnd(log.status(), now);
  };
}

Expected<std::vector<Agent>> placesForStrangers(const Options& options) {
  std::vector<host::AgentHello> robots;
  for (const std::string& words : options.strangers) {
    const auto robot = robotFrom(words);
    if (!robot) return Error{"'" + words + "': a stranger is TEAM:PLAYER, as in red:2"};
    robots.push_back(*robot);
  }
  if (options.robots == 0 && robots.empty()) return Error{"no robot plays"};
  return openStrangers(options.socket, robots, options.agentLimit);
}

// In their order.
Expected<std::vector<Agent>> allAgents(const Options& options, host::Listener& listener) {
  auto strangers = placesForStrangers(options);
  if (!strangers) return Error{strangers.error()};
  auto agents = gatherAgents(listener, options.robots, options.wait, cli::interrupted);
  if (agents) addStrangers(std::move(*strangers), options.agentWait, cli::interrupted, *agents);
  return agents;
}

Status play(const Options& options) {
  const auto field = fieldOf(options);
  if (!field) return Error{field.error()};
  const auto staging = stagingFrom(options.staging);
  if (!staging) return Error{staging.error()};
  std::optional<LogWriter> log;
  const Status logged = openLog(options, log);
  if (!logged) return logged;
  auto listener = host::Listener::open(options.socket);
  if (!listener) return Error{listener.error()};
  std::optional<ControlDesk> desk;
  if (options.controller != 0) {
    auto socket = host::UdpControl::open(options.controller, false);
    if (!socket) return Error{socket.error()};
    desk.emplace(std::move(*socket), options.controller);
  }
  auto agents = allAgents(options, *listener);
  if (!agents) return Error{agents.error()};
  std::vector<host::AgentHello> hellos;
  for (const Agent& agent : *agents) hellos.push_back(agent.hello);
  const auto setup = stagedScenario(options.scenario, *field, hellos, options.seed, *staging);
  if (!setup) return Error{setup.error()};
  World world(serverParams(options), *field, *setup, options.seed);
  Pace pace(options.realTime ? 1.0 : 0.0);
  OrderDesk orders(options.orders ? STDIN_FILENO : -1, world, pace, *field, hellos, tellLine);
  ServerHooks heard = hooks(options, *listener, world, pace, [&] { orders.hear(); });
  if (desk) heard.hear = [&] { desk->hear(world); };
  if (log) watchLog(*log, heard);
  const Status played = Server(world, *agents, log ? &*log : nullptr, heard).run();
  if (!played) return played;
  if (log && log->status()) {
    const Status closed = log->close();
    if (!closed) tellEnd(closed, world.time());  // as if it had been full in the last step
  }
  std::ofstream result;
  const Status opened = openResult(options, result);
  return opened ? writeResult(options, world, result) : opened;
}

void describe(cli::CommandLine& app, Options& options) {
  app.option("--socket", options.socket, "Unix socket the agents come to").required();
  app.option("--robots", options.robots, "agents to wait for").check(cli::integerInRange(0, 8));
  app.option("--stranger", options.strangers,
             "TEAM:PLAYER whose agent is somebody else's program and comes to SOCKET-red-1 and so "
             "on; nothing that it does stops the match");
  app.option("--agent-limit", options.agentLimit,
             "seconds of real time that such an agent has for each answer")
      .check(cli::inRange(0.001, 60.0));
  app.option("--agent-wait", options.agentWait, "seconds until such an agent must be there")
      .check(cli::inRange(0.0, 1e5));
  app.option("--game-controller", options.controller,
             "a game controller at this UDP port rules in place of the world's referee")
      .check(cli::integerInRange(1, 65535));
  app.flag("--respawn", options.respawn,
           "an agent that dies may come back; until then its robot stands");
  app.flag("--real-time", options.realTime, "no faster than a clock");
  app.flag("--orders", options.orders,
           "what a person orders, in lines on standard input: pause, resume, step, speed, ball, "
           "carry (tools/sim/staging/LiveOrder.h)");
  app.option("--wait", options.wait, "seconds until the agents must be there")
      .check(cli::inRange(0.0, 1e5));
  app.flag("--no-ring", options.noRing, "no ring effect");
  app.flag("--no-centres", options.noCentres, "every ring effect centred on the image");
  app.flag("--no-shine", options.noShine, "red uniforms without yellow and pink at their edges");
  app.flag("--no-own-legs", options.noOwnLegs, "no robot sees its own legs");
  app.flag("--no-noise", options.noNoise, "no sensor noise");
  app.flag("--no-shift", options.noShift, "no colour difference between robots");
  app.flag("--no-blur", options.noBlur, "no blur");
  app.flag("--no-rolling", options.noRolling, "all columns exposed at once");
  app.flag("--no-spectators", options.noSpectators, "nobody around the field");
  addWorldOptions(app, options);
}

}  // namespace
}  // namespace kelpie::sim

int main(int argc, char** argv) {
  kelpie::sim::Options options;
  kelpie::cli::ProgramLine app("The simulated world of one match", "kelpie-world");
  kelpie::sim::describe(app, options);
  bool done = false;
  const int usage = kelpie::cli::parseOptions(app, argc, argv, done);
  if (done) return usage;
  kelpie::cli::catchInterrupts();  // a match that is stopped still leaves log and result whole
  const kelpie::Status played = kelpie::sim::play(options);
  if (played) return 0;
  fmt::print(stderr, "kelpie-world: {}\n", played.error());
  return 1;
}
