// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/WorldOptions.h"

#include <fmt/core.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <utility>

namespace kelpie::sim {
namespace {

const char* nameOf(TeamColour team) { return team == TeamColour::red ? "red" : "blue"; }

const char* nameOf(PlayState state) {
  constexpr std::array<const char*, 5> kNames = {"initial", "ready", "set", "playing", "finished"};
  return kNames[static_cast<std::size_t>(state)];
}

// A world that is killed loses half a second of it.
LogOptions truthLogOptions(bool plain) {
  if (plain) return {};
  LogOptions options = defaultLogOptions();
  options.chunkUs = 400000;
  return options;
}

// What the log keeps about which match it is, for whoever draws it.
LogMap notesOf(const WorldOptions& options) {
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

}  // namespace

void addWorldOptions(cli::CommandLine& app, WorldOptions& options) {
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
  app.flag("--from-play", options.world.referee.fromPlay,
           "with --rules: no kick-off and one half, play goes on as it stands; --goals end it");
  app.option("--holding-distance", options.holdingDistance,
             "cm that a robot may carry the ball; 0: the field's")
      .check(cli::inRange(0.0, 500.0));
  app.option("--radio-loss", options.world.radio.loss, "share of packets that are lost")
      .check(cli::inRange(0.0, 1.0));
  app.option("--radio-delay", options.world.radio.delay, "s under way at least")
      .check(cli::inRange(0.0, 10.0));
  app.option("--radio-range", options.world.radio.range, "cm that a packet reaches")
      .check(cli::inRange(0.0, 1e5));
  app.flag("--plain-log", options.plainLog, "the log's records go out one by one, uncompressed");
  app.flag("--no-slip", options.noSlip, "feet do not slip");
  app.flag("--physical,!--fast", options.physical,
           "bodies with masses, servos and contacts (the default), or kinematic ones");
  cli::addRandomisationOptions(app, options.randomised);
  cli::addLeanOptions(app, options.randomised);
}

WorldParams worldParams(const WorldOptions& options) {
  WorldParams params = options.world;
  params.fast = !options.physical;
  params.randomised = cli::paramsOf(options.randomised);
  if (options.noSlip) params.robot.slipMean = params.robot.slipSd = params.robot.driftSd = 0.0;
  return params;
}

Expected<body::FieldDescription> fieldOf(const WorldOptions& options) {
  auto field = body::fieldDescription(options.field);
  if (field && options.world.referee.rules)
    field->rules.halfTime =
        (options.world.referee.fromPlay ? 1.0 : 0.5) * options.world.referee.seconds;
  if (field && options.holdingDistance > 0.0)
    field->rules.holdingDistance = options.holdingDistance;
  return field;
}

Status openLog(const WorldOptions& options, std::optional<LogWriter>& log) {
  if (options.truth.empty()) return Done{};
  auto opened = LogWriter::open(options.truth, truthLogOptions(options.plainLog));
  if (!opened) return Error{opened.error()};
  log = std::move(*opened);
  log->metadata(kMatchNotes, notesOf(options));
  return Done{};
}

Status openResult(const WorldOptions& options, std::ofstream& file) {
  if (options.result.empty()) return Done{};
  file.open(options.result);
  if (!file) return Error{"cannot write " + options.result};
  return Done{};
}

Status writeResult(const WorldOptions& options, const World& world, std::ofstream& file) {
  if (options.result.empty()) return Done{};
  const Score& score = world.score();
  std::string goals;
  for (const Goal& goal : score.goals)
    goals += fmt::format("{}{{\"team\":\"{}\",\"t_s\":{:.3f},\"own\":{}}}",
                         goals.empty() ? "" : ",", nameOf(goal.team), goal.time, goal.own);
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

void TimeTeller::operator()(TimeUs now) {
  if (now.us < next_.us) return;
  const net::GameControlData control = world_->control();
  next_ = {now.us + 500000};
  tellLine(fmt::format("time {:.3f} {} {} {} {} {}", now.seconds(), nameOf(control.state),
                       control.firstHalf ? 1 : 2, control.secondsLeft, world_->score().red,
                       world_->score().blue));
}

}  // namespace kelpie::sim
