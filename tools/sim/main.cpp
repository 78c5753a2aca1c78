// SPDX-License-Identifier: Apache-2.0
// kelpie-world: the simulated match as a process. Waits for its agents at a Unix socket, plays one
// match with them in lock step, writes what really happened, and ends.
#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <functional>
#include <optional>
#include <utility>

#include "robot/host/radio/UdpControl.h"
#include "tools/cli/AgentTalk.h"
#include "tools/cli/Process.h"
#include "tools/cli/options/RandomisationOptions.h"
#include "tools/cli/options/StagingOptions.h"
#include "tools/cli/options/Usage.h"
#include "tools/sim/referee/UnusedControl.h"
#include "tools/sim/staging/Staging.h"
#include "tools/sim/world/OrderDesk.h"
#include "tools/sim/world/Pace.h"
#include "tools/sim/world/Server.h"

namespace kelpie::sim {
namespace {

struct Options {
  std::string socket;
  std::size_t robots = 1;
  std::uint64_t seed = 1;
  std::string field = "2006";
  std::string scenario = "empty-goal";
  std::string truth;
  std::string result;
  std::vector<std::string> notes;  // KEY=VALUE
  bool tellGoals = false;
  bool tellTime = false;
  bool realTime = false;
  bool orders = false;  // of a person, on standard input
  bool plainLog = false;
  bool respawn = false;
  std::uint16_t controller = 0;  // UDP port where a game controller is heard; 0: the world rules
  double wait = 60.0;            // s for the agents to come
  bool noRing = false, noNoise = false, noShift = false, noRolling = false;
  bool noBlur = false, noSlip = false, noSpectators = false;
  bool physical = true;
  bool noCentres = false, noShine = false, noOwnLegs = false;
  cli::RandomisationOptions randomised;
  StagingWords staging;
  WorldParams world;
};

WorldParams worldParams(const Options& options) {
  WorldParams params = options.world;
  ArtefactParams& artefacts = params.camera.artefacts;
  artefacts.ring = !options.noRing;
  artefacts.noise = !options.noNoise;
  artefacts.shift = !options.noShift;
  artefacts.blur = !options.noBlur;
  artefacts.centres = !options.noCentres;
  params.shine.on = !options.noShine;
  params.ownLegs = !options.noOwnLegs;
  params.fast = !options.physical;
  params.rolling = !options.noRolling;
  params.spectators = !options.noSpectators;
  params.randomised = cli::paramsOf(options.randomised);
  params.referee.controlled = options.controller != 0;
  if (options.noSlip) params.robot.slipMean = params.robot.slipSd = params.robot.driftSd = 0.0;
  return params;
}

const char* nameOf(TeamColour team) { return team == TeamColour::red ? "red" : "blue"; }

Status writeResult(const Options& options, const World& world) {
  if (options.result.empty()) return Done{};
  const Score& score = world.score();
  std::string goals;
  for (const Goal& goal : score.goals)
    goals += fmt::format("{}{{\"team\":\"{}\",\"t_s\":{:.3f},\"own\":{}}}",
                         goals.empty() ? "" : ",", nameOf(goal.team), goal.time, goal.own);
  std::ofstream file(options.result);
  file << fmt::format("{{\"goals\":[{}],\"seconds\":{:.3f},\"outs\":{},\"seed\":{}}}\n", goals,
                      world.time().seconds(), score.outs, options.seed);
  file.close();
  if (!file) return Error{"cannot write " + options.result};
  return Done{};
}

void tellLine(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

// Goals are reported as they fall: "goal red 19.633"; interventions are reported to the user, and
// who rules from outside hears of a ball that is in one.
void tell(const MatchEvent& event) {
  const double now = event.time.seconds();
  if (event.kind == EventKind::goal)
    tellLine(fmt::format("goal {} {:.3f}", nameOf(event.team), now));
  if (event.kind == EventKind::out && event.reason.view() == kInGoal)
    tellLine(fmt::format("the ball is in the {} goal", nameOf(otherTeam(event.team))));
  if (event.kind == EventKind::taken)
    tellLine(fmt::format("{:.1f} s: the ball is taken away", now));
  if (event.kind == EventKind::returned)
    tellLine(fmt::format("{:.1f} s: the ball is back at ({:.0f}, {:.0f})", now, event.place.x,
                         event.place.y));
  if (event.kind == EventKind::carried)
    tellLine(fmt::format("{:.1f} s: {} {} is carried to ({:.0f}, {:.0f})", now, nameOf(event.team),
                         event.player, event.place.x, event.place.y));
}

const char* nameOf(PlayState state) {
  constexpr std::array<const char*, 5> kNames = {"initial", "ready", "set", "playing", "finished"};
  return kNames[static_cast<std::size_t>(state)];
}

// Twice a simulated second: "time 12.5 playing 1 290 0 1" (tools/session reads it).
class TimeTeller {
 public:
  explicit TimeTeller(const World& world) : world_(&world) {}

  void operator()(TimeUs now) {
    if (now.us < next_.us) return;
    const net::GameControlData control = world_->control();
    next_ = {now.us + 500000};
    tellLine(fmt::format("time {:.3f} {} {} {} {} {}", now.seconds(), nameOf(control.state),
                         control.firstHalf ? 1 : 2, control.secondsLeft, world_->score().red,
                         world_->score().blue));
  }

 private:
  const World* world_;
  TimeUs next_;
};

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

// A world that is killed loses half a second of it.
LogOptions truthLogOptions(bool plain) {
  if (plain) return {};
  LogOptions options = defaultLogOptions();
  options.chunkUs = 400000;
  return options;
}

// A log that cannot be written any more is reported once, and the match goes on.
void watchLog(const LogWriter& log, ServerHooks& hooks) {
  hooks.beforeStep = [&log, before = hooks.beforeStep, reported = false](TimeUs now) mutable {
    before(now);
    if (reported || log.status()) return;
    reported = true;
    fmt::print("{}{}{:.1f} s\n", log.status().error(), cli::kLogEndsMark, now.seconds());
    std::fflush(stdout);
  };
}

// What the log keeps about which match it is, for whoever draws it.
LogMap notesOf(const Options& options) {
  LogMap notes = {{"seed", std::to_string(options.seed)},
                  {"field", options.field},
                  {"scenario", options.scenario},
                  {"bodies", options.physical ? "physical" : "fast"}};
  for (const std::string& note : options.notes) {
    const std::size_t equals = note.find('=');
    if (equals != std::string::npos) notes[note.substr(0, equals)] = note.substr(equals + 1);
  }
  return notes;
}

Status play(const Options& options) {
  auto field = body::fieldDescription(options.field);
  if (!field) return Error{field.error()};
  if (options.world.referee.rules) field->rules.halfTime = 0.5 * options.world.referee.seconds;
  const auto staging = stagingFrom(options.staging);
  if (!staging) return Error{staging.error()};
  std::optional<LogWriter> log;
  if (!options.truth.empty()) {
    auto opened = LogWriter::open(options.truth, truthLogOptions(options.plainLog));
    if (!opened) return Error{opened.error()};
    log = std::move(*opened);
    log->metadata(kMatchNotes, notesOf(options));
  }
  auto listener = host::Listener::open(options.socket);
  if (!listener) return Error{listener.error()};
  std::optional<ControlDesk> desk;
  if (options.controller != 0) {
    auto socket = host::UdpControl::open(options.controller, false);
    if (!socket) return Error{socket.error()};
    desk.emplace(std::move(*socket), options.controller);
  }
  auto agents = gatherAgents(*listener, options.robots, options.wait, cli::interrupted);
  if (!agents) return Error{agents.error()};
  std::vector<host::AgentHello> hellos;
  for (const Agent& agent : *agents) hellos.push_back(agent.hello);
  const auto setup = stagedScenario(options.scenario, *field, hellos, options.seed, *staging);
  if (!setup) return Error{setup.error()};
  World world(worldParams(options), *field, *setup, options.seed);
  Pace pace(options.realTime ? 1.0 : 0.0);
  OrderDesk orders(options.orders ? STDIN_FILENO : -1, world, pace, *field, hellos, tellLine);
  ServerHooks heard = hooks(options, *listener, world, pace, [&] { orders.hear(); });
  if (desk) heard.hear = [&] { desk->hear(world); };
  if (log) watchLog(*log, heard);
  const Status played = Server(world, *agents, log ? &*log : nullptr, heard).run();
  if (!played) return played;
  if (log && log->status()) {
    const Status closed = log->close();
    if (!closed) return closed;
  }
  return writeResult(options, world);
}

void describe(cli::CommandLine& app, Options& options) {
  app.option("--socket", options.socket, "Unix socket the agents come to").required();
  app.option("--robots", options.robots, "agents to wait for").check(cli::integerInRange(1, 8));
  app.option("--seed", options.seed, "of everything random")
      .check(cli::inRange(0.0, cli::kLargestSeed));
  app.option("--field", options.field, "2006, osaka2005 or 2004")
      .check(cli::oneOf({"2006", "osaka2005", "2004"}));
  app.option("--scenario", options.scenario, "attack, empty-goal or kickoff")
      .check(cli::oneOf({"attack", "empty-goal", "kickoff"}));
  cli::addStagingOptions(app, options.staging);
  app.option("--seconds", options.world.referee.seconds,
             "length of the match; with --rules of play, half of it in each half")
      .check(cli::inRange(0.0, 1e5));
  app.option("--goals", options.world.referee.goals, "of one team end the match; 0 = never")
      .check(cli::integerInRange(0, 100));
  app.option("--truth", options.truth, "log of what really happened (MCAP)");
  app.option("--result", options.result, "result file (JSON)");
  app.option("--note", options.notes, "KEY=VALUE about the match, kept in the log");
  app.flag("--tell-goals", options.tellGoals, "each goal as a line on standard output");
  app.flag("--tell-time", options.tellTime,
           "with --rules: time, state and score twice a simulated second");
  app.flag("--rules", options.world.referee.rules,
           "a referee who knows more than goals, balls out and the end");
  app.option("--game-controller", options.controller,
             "a game controller at this UDP port rules in place of the world's referee")
      .check(cli::integerInRange(1, 65535));
  app.flag("--respawn", options.respawn,
           "an agent that dies may come back; until then its robot stands");
  app.option("--radio-loss", options.world.radio.loss, "share of packets that are lost")
      .check(cli::inRange(0.0, 1.0));
  app.option("--radio-delay", options.world.radio.delay, "s under way at least")
      .check(cli::inRange(0.0, 10.0));
  app.option("--radio-range", options.world.radio.range, "cm that a packet reaches")
      .check(cli::inRange(0.0, 1e5));
  app.flag("--real-time", options.realTime, "no faster than a clock");
  app.flag("--orders", options.orders,
           "what a person orders, in lines on standard input: pause, resume, step, speed, ball, "
           "carry (tools/sim/staging/LiveOrder.h)");
  app.flag("--plain-log", options.plainLog, "the log's records go out one by one, uncompressed");
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
  app.flag("--no-slip", options.noSlip, "feet do not slip");
  app.flag("--no-spectators", options.noSpectators, "nobody around the field");
  app.flag("--physical,!--fast", options.physical,
           "bodies with masses, servos and contacts (the default), or kinematic ones");
  cli::addRandomisationOptions(app, options.randomised);
  cli::addLeanOptions(app, options.randomised);
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
