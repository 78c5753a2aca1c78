// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>

#include "robot/host/radio/UdpControl.h"
#include "robot/net/GameControlData.h"
#include "tools/cli/Commands.h"
#include "tools/cli/DataFolder.h"
#include "tools/cli/Process.h"
#include "tools/cli/Progress.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/log/Logs.h"
#include "tools/cli/match/StrangerOptions.h"
#include "tools/cli/match/Watch.h"
#include "tools/cli/options/Config.h"
#include "tools/cli/options/StagingOptions.h"
#include "tools/cli/show/Film.h"
#include "tools/league/value/Report.h"
#include "tools/session/MatchFolder.h"
#include "tools/session/MatchLine.h"
#include "tools/session/Others.h"
#include "tools/session/PerceptSession.h"
#include "tools/session/SceneSession.h"
#include "tools/session/Session.h"
#include "tools/session/SessionCommands.h"
#include "tools/session/Teams.h"
#include "tools/sim/staging/Scenes.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

constexpr double kLongestMatch = 3600.0;  // s
constexpr int kMaxGoals = 99;
constexpr int kEarlierMatches = 5;  // kept in the default folder

struct PlayOptions {
  SessionOptions session;
  std::string out = "out";
  std::string images = "some";
  std::string logs = "watched";
  std::string opponent = "none";
  std::string robots;  // "4v4"; empty: the one robot, and its opponent
  std::string scene;   // "corner"; empty: none
  std::string rules = "2006";
  std::string red, blue;   // folders of the teams
  std::string controller;  // "udp" or "udp:PORT"; empty: the world's referee rules
  sim::StagingWords staging;
  double minutes = 10.0;
  bool noFilm = false;
  bool ownFolder = false;               // nobody named another than `out`
  std::function<Status()> moveEarlier;  // as SessionTalk::logs
  WatchOptions watched;
  std::unique_ptr<Watch> watch;

  std::string file(const char* name) const { return out + "/" + name; }
};

// "19.6, 44.0"
std::string listOf(const std::vector<double>& seconds) {
  std::string text;
  for (const double t : seconds) text += fmt::format("{}{:.1f}", text.empty() ? "" : ", ", t);
  return text;
}

std::string score(const PlayOptions& options, const SessionResult& result) {
  const bool red = options.session.team == "red";
  const std::size_t own = result.goals.size(), other = result.ownGoals.size();
  return fmt::format("red {} : {} blue", red ? own : other, red ? other : own);
}

std::string outcome(const SessionResult& result) {
  std::string text = result.goals.empty() ? fmt::format("no goal in {:.0f} s", result.seconds)
                                          : "GOAL after " + listOf(result.goals) + " s";
  if (!result.ownGoals.empty()) text += ", own goal after " + listOf(result.ownGoals) + " s";
  return text;
}

// The picture first: whoever interrupts the film keeps it. What cannot be drawn is said in a line;
// the match and its log are there all the same.
int makePictures(const PlayOptions& options, const std::vector<std::string>& others) {
  const auto match = match::Match::open(options.session.log);
  if (!match) return fail(match.error(), kExitMachine);
  int code = kExitDone;
  const Status picture = drawMatchPicture(*match, options.file("match.png"));
  if (!picture) code = fail(picture.error(), kExitMachine);
  if (options.noFilm || interrupted()) return code;
  FilmRequest request{{options.session.log}, "broadcast", options.file("match.mp4"), false};
  for (const std::string& log : others)
    if (log != options.session.log) request.logs.push_back(log);
  std::vector<std::string> lacks;
  const Status film = filmMatch(*match, request, lacks);
  if (film || interrupted()) return code;
  return fail(film.error(), kExitMachine);
}

std::string describeLog(const PlayOptions& options, double seconds) {
  std::error_code error;
  const double megabytes = 1e-6 * static_cast<double>(fs::file_size(options.session.log, error));
  const auto log = [&](const std::string& images) {
    return fmt::format("log, {:.0f} MB: {}", megabytes, images);
  };
  if (!options.session.watchesKelpie()) return log("what the world saw, for no robot told more");
  if (options.session.percepts) return log("no images");
  if (options.session.images == ImagesKept::planes)
    return log(fmt::format("a class plane in {} frames", kPlaneEvery));
  if (options.session.images == ImagesKept::all || seconds <= kAllImagesSeconds)
    return log("every image");
  return log(
      fmt::format("every image of the first {:.0f} s, later one in {:.0f} s and pictures "
                  "(--images all keeps all)",
                  kAllImagesSeconds, kOneImageSeconds));
}

void nameLogs(const PlayOptions& options, const std::vector<std::string>& logs) {
  double bytes = 0.0;
  std::string names;
  std::error_code error;
  for (const std::string& log : logs) {
    bytes += static_cast<double>(fs::file_size(log, error));
    if (log != options.session.log) names += " " + fs::path(log).filename().string();
  }
  fmt::print("{}:{}: the other robots' logs; {:.0f} MB in all\n", options.out, names, 1e-6 * bytes);
}

void nameFiles(const PlayOptions& options, double seconds) {
  const auto name = [&](const char* file, const std::string& what) {
    if (fs::exists(options.file(file))) fmt::print("{}: {}\n", options.file(file), what);
  };
  name("match.png", "the match in one picture: paths and six moments");
  name("match.mp4", "film: the match in 3D, what the robot sees and why it acts");
  name("match.mcap", describeLog(options, seconds));
  if (!options.noFilm && !fs::exists(options.file("match.mp4")))
    fmt::print("the film was left out; kelpie film {} {} makes it\n", options.session.log,
               options.file("match.mp4"));
}

// What is wrong with the options is reported before anything is started or an earlier match
// replaced.
Status checkConfig(const SessionOptions& session) {
  ConfigOptions config;
  config.field = session.field;
  config.team = session.team;
  config.colourTable = session.colourTable;
  config.ring = session.ring;
  config.params = session.params;
  config.set = session.set;
  const auto made = makeConfig(config);
  if (!made) return Error{made.error()};
  return session.pycode.empty() ? Status(Done{}) : checkScripts(session.pycode);
}

// A keeper of the other team knows what it is by its parameters. It is Kelpie's own, whatever plays
// against it: a team's main.py that knows no goalie would leave the goal.
void addOpponent(PlayOptions& options) {
  if (options.opponent == "none") return;
  const PlayerKind kind =
      options.opponent == "goalie" ? PlayerKind::goalie : PlayerKind::goalie2004;
  OtherRobot keeper;
  keeper.team = options.session.team == "red" ? "blue" : "red";
  keeper.set = {fmt::format("behaviour.task.player={}", static_cast<int>(kind))};
  keeper.seed = options.session.seed;
  options.session.others = {keeper};
}

// "thesis" of teams/thesis/; what the source tree's own behaviours play is kelpie.
std::string nameOf(const std::string& folder, const std::string& pycode) {
  const fs::path path(folder.empty() ? pycode : folder);
  const std::string name = (path.has_filename() ? path : path.parent_path()).stem().string();
  return name.empty() || name == "pycode" ? "kelpie" : name;
}

// Whose teams play: for the titles of pictures. A team without robots has no name.
void addNames(PlayOptions& options) {
  SessionOptions& session = options.session;
  const auto plays = [&](const char* team) {
    return session.team == team ||
           std::any_of(session.others.begin(), session.others.end(),
                       [&](const OtherRobot& robot) { return robot.team == team; });
  };
  const bool keeper = options.opponent != "none";
  const std::string keeps = options.opponent == "goalie" ? "goalie of 2006" : "goalie of 2004";
  for (const char* team : {"red", "blue"}) {
    const bool other = keeper && session.team != team;
    const std::string& folder = std::string(team) == "red" ? options.red : options.blue;
    const std::string& command = session.strangerOf(team);
    const std::string name = !command.empty() ? programIn(command)
                             : other          ? keeps
                                              : nameOf(folder, session.pycode);
    if (plays(team)) session.notes.push_back(std::string(team) + "=" + name);
  }
}

Status addTeams(PlayOptions& options) {
  useRules(options.rules, options.session);
  if (!options.scene.empty())
    return useScene(options.scene, {0, 0, options.red, options.blue}, options.session);
  if (options.robots.empty() && options.red.empty() && options.blue.empty()) return Done{};
  auto plan = teamPlan(options.robots.empty() ? "4v4" : options.robots);
  if (!plan) return Error{plan.error()};
  plan->redFolder = options.red.empty() ? defaultTeam() : options.red;
  plan->blueFolder = options.blue.empty() ? defaultTeam() : options.blue;
  return useTeams(*plan, options.session);
}

// A controller is a person, whose minute is a minute.
Status addController(PlayOptions& options) {
  if (options.controller.empty()) return Done{};
  const std::string port =
      options.controller.substr(std::min<std::size_t>(3, options.controller.size()));
  int number = net::kGameControlPort;
  if (!port.empty()) {
    const char* const end = port.data() + port.size();
    const auto [rest, error] = std::from_chars(port.data() + 1, end, number);
    if (port[0] != ':' || error != std::errc() || rest != end) number = 0;
  }
  if (options.controller.compare(0, 3, "udp") != 0 || number < 1 || number > 65535)
    return Error{"--game-controller " + options.controller + ": expected udp or udp:PORT"};
  options.session.controller = static_cast<std::uint16_t>(number);
  // The world would find out too late: its agents would wait for it.
  const auto free = host::UdpControl::open(options.session.controller, false);
  if (!free) return Error{free.error()};
  options.session.rules = true;
  return Done{};
}

// The world would refuse the same, but only after the start.
Status stage(PlayOptions& options) {
  SessionOptions& session = options.session;
  if (!options.scene.empty()) return Done{};
  const auto staging = sim::stagingFrom(options.staging);
  if (!staging) return Error{staging.error()};
  session.staging = *staging;
  const auto setup = sim::stagedScenario(session.scenario, *body::fieldDescription(session.field),
                                         robotsOf(session), session.seed, session.staging);
  return setup ? Status(Done{}) : Status(Error{setup.error()});
}

// A match of two teams tells how far it is, the match of one robot what that believes.
SessionResult runTeams(const PlayOptions& options) {
  MatchProgress progress(options.session.seconds);
  SessionTalk talk;
  talk.time = [&](const MatchTime& now) { progress(now); };
  talk.line = [&](const std::string& line) {
    progress.clear();
    fmt::print(stderr, "{}\n", line);
  };
  talk.goal = [&](bool own, double seconds) {
    const bool red = own == (options.session.team == "red");
    talk.line(fmt::format("GOAL of {} after {:.1f} s", red ? "red" : "blue", seconds));
  };
  talk.logs = options.moveEarlier;
  if (options.watch) options.watch->listenTo(talk);
  SessionResult result = runSession(options.session, talk);
  progress.finish();
  return result;
}

SessionResult runAlone(const PlayOptions& options) {
  LiveLine live;
  int goals = 0;
  int ownGoals = 0;
  SessionTalk talk;
  talk.status = [&](const std::string& line) {
    live(fmt::format("{}:{}  {}", goals, ownGoals, line));
  };
  talk.line = [&](const std::string& line) {
    live.clear();
    fmt::print(stderr, "{}\n", line);
  };
  talk.goal = [&](bool own, double seconds) {
    ++(own ? goals : ownGoals);
    talk.line(fmt::format("{} after {:.1f} s", own ? "GOAL" : "own goal", seconds));
  };
  if (options.session.controller != 0)
    fmt::print(stderr, "waiting in the initial state for a game controller at UDP port {}\n",
               options.session.controller);
  talk.logs = options.moveEarlier;
  if (options.watch) options.watch->listenTo(talk);
  SessionResult result = runSession(options.session, talk);
  live.finish();
  return result;
}

SessionResult runShown(const PlayOptions& options) {
  if (!onTerminal())
    fmt::print(stderr, "playing: seed {}, {:.0f} simulated seconds at most\n", options.session.seed,
               options.session.seconds);
  return options.session.rules ? runTeams(options) : runAlone(options);
}

ImagesKept imagesKept(const std::string& word) {
  if (word == "all") return ImagesKept::all;
  return word == "planes" ? ImagesKept::planes : ImagesKept::some;
}

// Shots and expected goals; a match in which nothing was played has none.
void tellWorth(const PlayOptions& options) {
  const auto models = value::readModels(value::modelFolder());
  if (!models) return;
  const auto field = *body::fieldDescription(options.session.field);
  const auto figures = value::figuresOfLog(options.session.log, *models, field);
  if (figures && figures->played > 0.0) fmt::print("{}\n", value::lineOf(*figures));
}

// What was played is reported all the same; a match without a goal is done, too.
int exitCode(const PlayOptions& options, const SessionResult& result) {
  if (!result.logTrouble.empty()) return fail(result.logTrouble, kExitMachine);
  // A match in real time ends by an interrupt; any other is cut short by it.
  if (result.interrupted && !options.session.realTime) return fail("interrupted", kExitInterrupted);
  return kExitDone;
}

Status prepare(PlayOptions& options) {
  const Status checked = checkConfig(options.session);
  if (!checked) return checked;
  addOpponent(options);
  const Status teams = addTeams(options);
  if (!teams) return teams;
  const Status strangers = checkStrangers(options.session);
  if (!strangers) return strangers;
  options.noFilm = options.noFilm || !options.session.watchesKelpie();
  addNames(options);
  const Status controlled = addController(options);
  if (!controlled) return controlled;
  if (options.session.percepts) {
    const Status fits = mayBePercepts(options.session);
    if (!fits) return fits;
  }
  return stage(options);
}

int tellMatch(const PlayOptions& options, const SessionResult& result, double took) {
  if (!result.trouble.empty())
    return fail(result.trouble, result.badInput      ? kExitBadInput
                                : result.interrupted ? kExitInterrupted
                                                     : kExitMachine);
  const bool drawn = result.logged && options.session.watchesKelpie();
  const int pictures = drawn ? makePictures(options, result.logs) : kExitDone;
  nameFiles(options, result.seconds);
  if (options.session.allLogs) nameLogs(options, result.logs);
  if (options.session.rules && result.logged) tellWorth(options);
  fmt::print("{} (seed {}, {:.1f} simulated seconds in {:.1f} s)\n",
             options.session.rules ? score(options, result) : outcome(result), options.session.seed,
             result.seconds, took);
  const int code = exitCode(options, result);
  return code == kExitDone ? pictures : code;
}

Status beginWatch(PlayOptions& options) {
  prepareWatched(options.watched, options.session);
  if (!options.watched.any()) return Done{};
  auto watch = Watch::begin(options.watched, options.session, options.out);
  if (!watch) return Error{watch.error()};
  options.watch = std::move(*watch);
  for (const std::string& line : options.watch->lines()) fmt::print(stderr, "{}\n", line);
  return Done{};
}

// The match before moves away when the logs of this one take its place.
int playInto(MatchFolder& folder, PlayOptions& options) {
  for (const auto& note : folder.notes()) fmt::print(stderr, "{}\n", note);
  options.out = folder.path();
  options.session.log = options.file("match.mcap");
  options.session.images = imagesKept(options.images);
  options.session.allLogs = options.logs == "all" && !options.session.others.empty();
  options.moveEarlier = [&folder] { return folder.moveEarlier(); };
  const Status watched = beginWatch(options);
  if (!watched) {
    forgetParts(options.out);
    return fail(watched.error(), kExitBadInput);
  }
  const auto start = std::chrono::steady_clock::now();
  const SessionResult result = runShown(options);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  if (result.logged && options.ownFolder) folder.forgetAllBut(kEarlierMatches);
  const int code = tellMatch(options, result, took.count());
  if (options.watch && code == kExitDone) options.watch->stay();
  return code;
}

int play(PlayOptions& options) {
  const Status ready = prepare(options);
  if (!ready) return fail(ready.error(), kExitBadInput);
  catchInterrupts();
  auto folder = MatchFolder::take(options.out);
  if (!folder) return fail(folder.error(), kExitBadInput);
  return playInto(*folder, options);
}

void addTeamOptions(CommandLine& command, PlayOptions& options) {
  SessionOptions& session = options.session;
  command.option("--robots", options.robots, "Teams that play by the rules from a kick-off, as 4v4")
      .check(notEmpty())
      .excludes("--opponent")
      .excludes("--scenario");
  addRulesOption(command, options.rules);
  command.option("--red", options.red, "The red team's folder: main.py, team.toml or both")
      .checkTeam(dataFolder())
      .excludes("--opponent");
  command.option("--blue", options.blue, "The blue team's folder")
      .checkTeam(dataFolder())
      .excludes("--opponent");
  command.flag("--trust", session.trust,
               "Scripts that did not come with Kelpie may do all that the user may: without it "
               "they read their own folder and nothing else (docs/behaviours.md)");
  command.option("--minutes", options.minutes, "The same as 60 --seconds")
      .check(inRange(0.1, kLongestMatch / 60.0))
      .excludes("--seconds");
  command
      .option("--radio", session.radio,
              "How teams are heard: through the world, not at all (none), or udp of this "
              "machine (such a match does not replay)")
      .check(oneOf({"world", "udp", "none"}))
      .showDefault();
  command
      .option("--radio-loss", session.radioLoss,
              "Share of the team's packets that a robot misses (the world's: 0.02)")
      .check(inRange(0.0, 1.0));
  command
      .option("--radio-delay", session.radioDelay,
              "Seconds that a packet is under way (the world's: 0.01 to 0.04)")
      .check(inRange(0.0, 10.0));
  command
      .option("--logs", options.logs,
              "Whose logs are kept: watched (match.mcap), or all, of every other robot too "
              "(red-1.mcap, ...), with --images planes unless that says otherwise of "
              "match.mcap; at most 150 MB for ten minutes of 4v4")
      .check(oneOf({"watched", "all"}))
      .showDefault();
  command
      .option("--game-controller", options.controller,
              "udp or udp:PORT: a game controller rules, in real time, in place of the "
              "world's referee; port 3838 if none is given (kelpie gamecontroller is one)")
      .check(notEmpty());
  command.flag("--end-with-log", session.endWithLog,
               "A log that cannot be written any more (a full disk) ends the match; without "
               "this it goes on");
  command.flag("--respawn", session.respawn, "An agent that dies is started again and plays on");
}

// Of a situation nothing else is to be said than who plays it.
void addSceneOption(CommandLine& command, PlayOptions& options) {
  auto scene = command
                   .option("--scene", options.scene,
                           "A situation of a match, drawn by --seed, until a goal or for 15 to 20 "
                           "s: free-ball, contested, own-box, corner, ... (tools/sim/README.md)")
                   .check(oneOf(sim::sceneKinds()));
  for (const char* other : {"--robots", "--opponent", "--scenario", "--seconds", "--goals",
                            "--place", "--ball", "--throw", "--take-ball", "--carry", "--deaf"})
    scene.excludes(other);
}

// What was not said follows from what was.
void settle(const CommandLine& command, PlayOptions& options) {
  SessionOptions& session = options.session;
  const auto said = [&](const char* option) { return command.count(option) > 0; };
  session.realTime = session.realTime || said("--game-controller") || options.watched.studio;
  const bool teams = said("--robots") || said("--red") || said("--blue") || said("--scene");
  if (session.realTime && !said("--seconds")) session.seconds = kLongestMatch;
  if (said("--minutes")) session.seconds = 60.0 * options.minutes;
  if ((teams || session.realTime) && !said("--goals") && !said("--scene"))
    session.goals = kMaxGoals;
  if (options.opponent != "none" && !said("--scenario")) session.scenario = "attack";
  if (options.logs == "all" && !said("--images")) options.images = "planes";
  if (session.percepts) options.noFilm = true;
  options.ownFolder = !said("--out");
}

}  // namespace

void addPlay(CommandLine& app, int& code) {
  auto command = app.subcommand("play", "One robot plays in the simulated world, or two teams do");
  auto options = std::make_shared<PlayOptions>();
  auto& session = options->session;
  command
      .option("--out", options->out,
              "Folder for match.mcap, match.mp4 and match.png; what a match before left there "
              "moves into its folder earlier/ (of out, five are kept)")
      .showDefault();
  command.option("--seed", session.seed, "Start pose, ball, noise and slip")
      .check(inRange(0.0, kLargestSeed))
      .showDefault();
  command
      .option("--seconds", session.seconds, "Simulated time at most; with --robots, time of play")
      .check(inRange(1.0, kLongestMatch))
      .showDefault();
  command.option("--goals", session.goals, "Ends after so many goals")
      .check(integerInRange(1, kMaxGoals))
      .showDefault();
  command
      .option("--scenario", session.scenario,
              "Who is where at the start: attack (far from the goal; what an "
              "opponent keeps to), empty-goal or kickoff")
      .check(oneOf({"attack", "empty-goal", "kickoff"}))
      .showDefault();
  command
      .option("--opponent", options->opponent,
              "Who keeps the other goal: none, goalie (of 2006) or goalie-2004")
      .check(oneOf({"none", "goalie", "goalie-2004"}))
      .showDefault();
  addStagingOptions(command, options->staging);
  addSideOptions(command, session.field, session.team);
  command.option("--pycode", session.pycode, "Folder of behaviours (default: pycode/)")
      .check(existingPath());
  command.option("--params", session.params, "TOML files, general to specific")
      .check(existingFile());
  command.option("--set", session.set,
                 "One parameter each, over the files': KEY=NUMBER or KEY=80cm, or true or false");
  command.option("--colour-table", session.colourTable, "Colour table file").check(existingFile());
  command.option("--ring", session.ring, "Ring correction: nominal, none, 2006 or a file")
      .showDefault();
  command.option("--drop-rate", session.dropRate, "Share of images lost on the way")
      .check(inRange(0.0, 1.0));
  command.option("--without", session.artefactsOff, "Camera artefacts switched off")
      .check(oneOf({"ring", "centres", "noise", "shift", "rolling", "blur", "shine", "own-legs",
                    "spectators"}));
  command.flag("--physical,!--fast", session.physical,
               "Bodies with masses, servos and contacts (the default), or kinematic ones");
  command
      .flag("--percepts", session.percepts,
            "No images: each robot gets the percepts that its vision would make of them, and all "
            "of the match is one process: a fifth of the processor time (with --fast)")
      .excludes("--ring");
  addRandomisationOptions(command, session.randomised);
  addLeanOptions(command, session.randomised);
  command
      .option("--images", options->images,
              "Which images the log keeps: some (all of the first 20 s, then one in 5 s; the "
              "others as JPEG pictures; a match of ten minutes takes 160 MB), all (1.3 GB) or "
              "planes (none, but one frame in fifteen as the colour classes that vision makes of "
              "it; 16 MB; does not replay)")
      .check(oneOf({"some", "all", "planes"}))
      .excludes("--percepts")
      .showDefault();
  command.flag("--real-time", session.realTime,
               "No faster than a clock, and until Ctrl-C unless --seconds or --goals say "
               "otherwise: for editing pycode/ while it plays");
  addTeamOptions(command, *options);
  addStrangerOptions(command, session);
  addWatchOptions(command, options->watched);
  command.flag("--no-film", options->noFilm, "Leave out match.mp4");
  addSceneOption(command, *options);
  command.callback([=, &code] {
    settle(command, *options);
    const Status sound = checkStrangerOptions(command, options->session);
    code = sound ? play(*options) : fail(sound.error(), kExitBadInput);
  });
}

}  // namespace kelpie::cli
