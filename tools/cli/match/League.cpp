// SPDX-License-Identifier: Apache-2.0
// kelpie league: many matches between the folders of several teams, and who plays better. What
// plays until that is decided, on one machine or many, is the farm (tools/farm), which asks here
// for single matches.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <thread>
#include <tuple>

#include "robot/core/Checksum.h"
#include "tools/cli/Commands.h"
#include "tools/cli/DataFolder.h"
#include "tools/cli/Process.h"
#include "tools/cli/Progress.h"
#include "tools/cli/Version.h"
#include "tools/cli/match/Farm.h"
#include "tools/cli/options/Config.h"
#include "tools/cli/options/RandomisationOptions.h"
#include "tools/cli/options/StagingOptions.h"
#include "tools/league/JournalLines.h"
#include "tools/league/Run.h"
#include "tools/league/Table.h"
#include "tools/league/value/Report.h"
#include "tools/session/SceneSession.h"
#include "tools/session/Session.h"
#include "tools/session/Teams.h"
#include "tools/sim/staging/Scenes.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

struct LeagueOptions {
  std::vector<std::string> folders;
  std::string out = "out/league";
  std::string robots = "4v4";
  std::string scene;  // of `once`: a situation in place of a match
  std::string rules = "2006";
  league::LeaguePlan plan;
  int workers = 0;  // 0: one for two cores
  bool physical = false;
  bool percepts = false;
  bool trust = false;
  bool table = false;
  bool once = false;
  bool about = false;
  std::string until;
  std::string by, bounds, scheduler;  // of `until`
};

using Folders = std::map<std::string, std::string>;  // of each side

std::string nameOf(const std::string& folder) {
  fs::path path = fs::path(folder).lexically_normal();
  if (path.filename().empty()) path = path.parent_path();
  return path.filename().string();
}

std::string contentOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// A CRC-32 over names and contents of all that a team's folder holds.
std::string hashOf(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() != ".pyc")
      files.push_back(entry.path().lexically_relative(folder).string());
  std::sort(files.begin(), files.end());
  std::string all;
  for (const std::string& file : files) all += file + '\n' + contentOf(fs::path(folder) / file);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(all.data());
  return fmt::format("{:08x}", crc32(bytes, all.size()));
}

// A folder that a team can play from, with parameters that there are.
Status checkSide(const std::string& folder) {
  TeamPlan alone{1, 0, folder, ""};
  SessionOptions tried;
  const Status usable = useTeams(alone, tried);
  if (!usable) return usable;
  ConfigOptions parameters;
  parameters.params = tried.params;
  return applyConfig(parameters, *std::make_unique<agent::AgentConfig>());
}

Status readSides(LeagueOptions& options, Folders& folders) {
  const auto robots = teamPlan(options.robots);
  if (!robots) return Error{robots.error()};
  options.plan.about = versionLine() + ", " + options.robots;
  if (options.rules != "2006") options.plan.about += ", rules of " + options.rules;
  if (options.percepts) options.plan.about += ", percepts";
  for (const std::string& folder : options.folders) {
    const std::string name = nameOf(folder);
    const Status usable = checkSide(folder);
    if (!usable) return usable;
    if (!folders.emplace(name, folder).second) return Error{"two sides are called '" + name + "'"};
    options.plan.sides.push_back(name);
    options.plan.about += ", " + name + " " + hashOf(folder);
  }
  return Done{};
}

league::MatchResult voided(const std::string& trouble) {
  league::MatchResult result;
  result.trouble = trouble;
  return result;
}

// What behaviours complain of, each thing once: a team whose every frame fails would else pass for
// one that plays badly. Of all workers.
class Complaints {
 public:
  void hear(const league::LeagueMatch& match, const std::string& line) {
    const std::size_t at = line.find("behaviour: ");
    if (at == std::string::npos) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!reported_.insert(line.substr(at)).second) return;
    fmt::print(stderr, "{} - {} (seed {}): {}\n", match.red, match.blue, match.seed, line);
  }

 private:
  std::mutex mutex_;
  std::set<std::string> reported_;
};

// What a match was worth, beside its result (tools/league/value); a scene of so many seconds, 0 for
// a match.
Expected<nlohmann::ordered_json> worthOf(const std::string& worldLog, double sceneSeconds) {
  const auto models = value::readModels(value::modelFolder());
  if (!models) return Error{models.error()};
  const auto figures = value::figuresOfLog(worldLog, *models, *body::fieldDescription("2006"));
  if (!figures) return Error{figures.error()};
  nlohmann::ordered_json worth = value::jsonOf(*figures);
  if (sceneSeconds > 0.0)
    worth["value"] = value::sceneValue(*figures, models->far.horizon, sceneSeconds);
  return worth;
}

// The pure function of a league: processes of its own, nothing kept. `worth`: filled with what
// worthOf() says; null: nobody asks.
league::MatchResult playMatch(const league::LeagueMatch& match, const LeagueOptions& options,
                              const Folders& folders, Complaints& complaints,
                              nlohmann::ordered_json* worth = nullptr) {
  league::MatchResult result;
  auto plan = teamPlan(options.robots);
  if (!plan) return voided(plan.error());
  plan->redFolder = folders.at(match.red);
  plan->blueFolder = folders.at(match.blue);
  SessionOptions session;
  session.seed = match.seed;
  session.seconds = 60.0 * match.minutes;
  session.physical = !match.fast;
  session.percepts = options.percepts;
  session.trust = options.trust;
  session.set = {kNoReload};
  useRules(options.rules, session);
  const Status used =
      options.scene.empty() ? useTeams(*plan, session) : useScene(options.scene, *plan, session);
  if (!used) return voided(used.error());
  SessionTalk talk;
  talk.line = [&](const std::string& line) { complaints.hear(match, line); };
  session.keepTruth = worth != nullptr;
  std::string unread;
  talk.frames = [&](const std::string&, const std::string& worldLog) {
    auto told = worthOf(worldLog, options.scene.empty() ? 0.0 : session.seconds);
    if (told)
      *worth = std::move(*told);
    else
      unread = told.error();
  };
  const SessionResult played = runSession(session, talk);
  result.trouble = played.interrupted ? "interrupted" : played.trouble;
  if (result.trouble.empty()) result.trouble = unread;
  result.redGoals = static_cast<int>(played.goals.size());
  result.blueGoals = static_cast<int>(played.ownGoals.size());
  if (session.team == "blue") std::swap(result.redGoals, result.blueGoals);
  result.redOwnGoals = played.redOwnGoals;
  result.blueOwnGoals = played.blueOwnGoals;
  result.outs = played.outs;
  result.seconds = played.seconds;
  return result;
}

int show(const LeagueOptions& options, const league::Standings& standings) {
  fmt::print("{}", league::textOf(standings));
  const Status written = league::writeTables(standings, options.out);
  if (!written) return fail(written.error(), kExitMachine);
  fmt::print("{0}/table.txt, table.html and table.png show the same\n", options.out);
  return kExitDone;
}

int showOnly(const LeagueOptions& options) {
  const auto record = league::readLeague(options.out);
  if (!record) return fail(record.error(), kExitBadInput);
  return show(options, league::standingsOf(*record));
}

int workersFor(const LeagueOptions& options) {
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  if (options.workers > 0) return options.workers;
  return options.percepts ? cores : std::max(1, cores / 2);
}

std::string lineOf(const league::LeagueMatch& match, const league::MatchResult& result) {
  if (!result.trouble.empty())
    return fmt::format("{} - {} (seed {}): void: {}", match.red, match.blue, match.seed,
                       result.trouble);
  return fmt::format("{} {} : {} {} (seed {})", match.red, result.redGoals, result.blueGoals,
                     match.blue, match.seed);
}

int playLeague(LeagueOptions& options) {
  Folders folders;
  const Status sides = readSides(options, folders);
  if (!sides) return fail(sides.error(), kExitBadInput);
  options.plan.fast = !options.physical;
  auto journal = league::LeagueJournal::open(options.out, options.plan);
  if (!journal) return fail(journal.error(), kExitBadInput);
  catchInterrupts();
  const std::size_t all = journal->schedule().size();
  std::size_t done = 0;
  for (const auto& result : journal->results()) done += result ? 1 : 0;
  const int workers = workersFor(options);
  if (done < all)
    fmt::print(stderr,
               "{} of {} matches to play, {} at a time; Ctrl-C stops, the same command goes on\n",
               all - done, all, workers);
  league::RunTalk talk;
  talk.finished = [&](std::size_t match, const league::MatchResult& result) {
    fmt::print(stderr, "{}/{} {}\n", ++done, all, lineOf(journal->schedule()[match].match, result));
  };
  talk.again = [](std::size_t, const std::string& trouble) {
    fmt::print(stderr, "once more: {}\n", trouble);
  };
  talk.stop = interrupted;
  Complaints complaints;
  const league::Play play = [&](const league::LeagueMatch& match) {
    return playMatch(match, options, folders, complaints);
  };
  const auto summary = league::runLeague(*journal, play, workers, talk);
  if (!summary) return fail(summary.error(), kExitMachine);
  const league::Standings standings = league::standingsOf({journal->plan(), journal->results()});
  const int shown = show(options, standings);
  if (summary->stopped)
    return fail(
        fmt::format("stopped; {} matches are left, the same command goes on", summary->left),
        kExitInterrupted);
  if (standings.voids > 0)  // those of earlier runs, too
    return fail(fmt::format("{} of {} matches are void", standings.voids, all), kExitCheckFailed);
  return shown;
}

// For the farm: what a match between two teams depends on, whichever of them is red, and one match.
// JSON on standard output; a match that was not played out is a failure with its trouble.
int playOnce(LeagueOptions options) {
  if (options.folders.size() != 2) return fail("one match has two teams", kExitBadInput);
  const std::string red = nameOf(options.folders[0]);
  const std::string blue = nameOf(options.folders[1]);
  std::sort(options.folders.begin(), options.folders.end(),
            [](const auto& a, const auto& b) { return nameOf(a) < nameOf(b); });
  Folders folders;
  const Status sides = readSides(options, folders);
  if (!sides) return fail(sides.error(), kExitBadInput);
  nlohmann::ordered_json answer{{"about", options.plan.about}};
  if (options.about) answer["scenes"] = sim::sceneKinds();
  if (options.once) {
    catchInterrupts();
    Complaints complaints;
    const league::LeagueMatch match{red, blue, options.plan.seed, options.plan.minutes,
                                    !options.physical};
    nlohmann::ordered_json worth;
    const auto result = playMatch(match, options, folders, complaints, &worth);
    if (!result.trouble.empty())
      return fail(result.trouble, interrupted() ? kExitInterrupted : kExitMachine);
    answer.update(nlohmann::ordered_json::parse(league::matchLine(0, match, result)));
    answer.update(worth);
  }
  fmt::print("{}\n", answer.dump());
  return kExitDone;
}

// The same teams and matches, as words for the farm.
int playUntilDecided(const LeagueOptions& options, const CommandLine& command) {
  std::vector<std::string> words{"play"};
  words.insert(words.end(), options.folders.begin(), options.folders.end());
  const auto pass = [&](const std::string& option, const std::string& value) {
    if (command.count(option) > 0) words.insert(words.end(), {option, value});
  };
  pass("--minutes", fmt::format("{}", options.plan.minutes));
  pass("--seed", fmt::format("{}", options.plan.seed));
  pass("--robots", options.robots);
  pass("--rules", options.rules);
  if (options.workers > 0) pass("--workers", fmt::format("{}", options.workers));
  pass("--out", options.out);
  pass("--by", options.by);
  pass("--bounds", options.bounds);
  pass("--scheduler", options.scheduler);
  words.insert(words.end(), {"--world", options.physical   ? "physical"
                                        : options.percepts ? "percepts"
                                                           : "images"});
  return becomeFarm(std::move(words));
}

void addOptions(CommandLine& command, LeagueOptions& options) {
  league::LeaguePlan& plan = options.plan;
  plan.matchesAPair = 20;
  command
      .option("TEAM", options.folders,
              "Folders of teams: main.py, team.toml or both; their names are the sides'")
      .checkTeam(dataFolder());
  command.option("--out", options.out, "Folder of the league: its journal and its tables")
      .showDefault();
  command
      .option("--matches", plan.matchesAPair,
              "Of each pair, an even number: every seed is played in both colours")
      .check(integerInRange(2, 10000))
      .showDefault();
  command.option("--minutes", plan.minutes, "Of play, in each match")
      .check(inRange(0.1, 60.0))
      .showDefault();
  command.option("--seed", plan.seed, "The first one")
      .check(inRange(0.0, kLargestSeed))
      .showDefault();
  command.option("--robots", options.robots, "A side").showDefault();
  command.option("--against", plan.reference, "The side that all others play, and they alone");
  command
      .option("--workers", options.workers,
              "Matches at a time (one for two cores; with --percepts one for each)")
      .check(integerInRange(1, 256));
  command.flag("--physical,!--fast", options.physical,
               "Bodies with masses and servos, or kinematic ones (the default)");
  command.flag("--percepts", options.percepts,
               "No images: percepts as vision would make them; a fifth of the processor time");
  command.flag("--trust", options.trust,
               "Scripts of the teams may do all that the user may (docs/behaviours.md)");
  addRulesOption(command, options.rules);
  command.flag("--table", options.table, "Plays nothing: shows what the league has come to");
  auto until =
      command.option("--until", options.until, "Plays two teams until it is known which is better")
          .check(oneOf({"decided"}))
          .excludes("--matches")
          .excludes("--against")
          .excludes("--table");
  for (const auto& [name, value, help] :
       {std::tuple{"--by", &options.by, "What decides: score, goals or value (score)"},
        std::tuple{"--bounds", &options.bounds, "LOW,HIGH: the two means to decide between"},
        std::tuple{"--scheduler", &options.scheduler,
                   "tcp://HOST:PORT of other machines' workers"}})
    command.option(name, *value, help).needs(until);
  auto once = command.flag("--once", options.once, "One match of two teams, the first red, as JSON")
                  .excludes("--until");
  command
      .option("--scene", options.scene,
              "In its place a situation of a match, drawn by --seed (kelpie play --scene)")
      .check(oneOf(sim::sceneKinds()))
      .needs(once)
      .excludes("--minutes")
      .excludes("--robots");
  command.flag("--about", options.about, "Plays nothing: what a match depends on, as JSON")
      .excludes("--until");
}

}  // namespace

void addLeague(CommandLine& app, int& code) {
  auto command = app.subcommand("league",
                                "Many matches between teams, and who plays better; goes on where "
                                "it was stopped");
  auto options = std::make_shared<LeagueOptions>();
  addOptions(command, *options);
  command.callback([=, &code] {
    if (!options->table && options->folders.size() < 2)
      code = fail("a league needs two teams at least", kExitBadInput);
    else if (options->table)
      code = showOnly(*options);
    else if (options->once || options->about)
      code = playOnce(*options);
    else if (!options->until.empty())
      code = playUntilDecided(*options, command);
    else
      code = playLeague(*options);
  });
}

}  // namespace kelpie::cli
