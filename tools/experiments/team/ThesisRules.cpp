// SPDX-License-Identifier: Apache-2.0
// Whether the theses' team plays the theses' rules: every row of chapters 4 to 6 of thesis 2006 and
// of chapter 4 of thesis 2004 with how often it was played in a match of ten minutes of that team
// against itself, counted from the traces of all robots (RuleCounter.h). A row whose situation did
// not come is brought about by a staged scene. `thesis-scenes` plays the scenes alone, each once on
// every seed. Rows, scenes, and why a row is nobody's to play: thesis_rules.json.
#include <algorithm>
#include <fstream>

#include "tools/cli/DataFolder.h"
#include "tools/cli/Process.h"
#include "tools/experiments/challenge/Challenge.h"
#include "tools/experiments/harness/ChildProcesses.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/match/AgentFrames.h"
#include "tools/experiments/skills/Tries.h"
#include "tools/experiments/team/RuleCounter.h"
#include "tools/session/Session.h"
#include "tools/session/Teams.h"

namespace kelpie::experiments {
namespace {

constexpr double kSeconds = 600.0;               // of the match
constexpr const char* kChallenge = "challenge";  // the scene that is no match
// A scene is played by other seeds until all of its rows have come.
constexpr int kTries = 8;
constexpr std::uint64_t kSeedStep = 1000;

std::string besideThis(const std::string& file) {
  return cli::dataFolder() + "/tools/experiments/team/" + file;
}

// Robots of the theses' team, without a referee from the first frame on: in the words of `kelpie
// play`.
struct Scene {
  std::string name;
  std::string robots;                 // "2v1"
  std::vector<std::string> places;    // of all of them
  std::vector<std::string> standing;  // places of blue ones that stand there
  std::string ball;
  std::vector<std::string> throws;
  std::vector<std::string> takes;
  std::vector<std::string> carries;
  std::vector<std::string> set;     // parameters of all robots,
  std::vector<std::string> keeper;  // and of each team's number 1
  std::string params;               // of the first robot: a TOML file beside this one; empty: none
  double seconds = 20.0;
  double again = 0.0;     // s after which throws and carries come once more, and so on; 0: never
  bool physical = false;  // also with --fast: kinematic bodies feel no paw

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("name", &Scene::name), field("robots", &Scene::robots),
                     field("places", &Scene::places), field("standing", &Scene::standing),
                     field("ball", &Scene::ball), field("throws", &Scene::throws),
                     field("takes", &Scene::takes), field("carries", &Scene::carries),
                     field("set", &Scene::set), field("keeper", &Scene::keeper),
                     field("params", &Scene::params), field("seconds", &Scene::seconds),
                     field("again", &Scene::again), field("physical", &Scene::physical));
  }
};

struct Table {
  std::vector<Rule> rules;
  std::vector<Scene> scenes;
};

// A member that a row does not name has its default.
template <class T>
std::vector<T> listFrom(const Json& rows) {
  std::vector<T> list;
  for (const Json& row : rows) {
    Json whole = toJson(T{});
    whole.update(row);
    list.emplace_back();
    fromJson(whole, list.back());
  }
  return list;
}

Expected<Table> readTable() {
  const std::string path = besideThis("thesis_rules.json");
  std::ifstream file(path);
  const Json json = Json::parse(file, nullptr, false);
  if (json.is_discarded()) return Error{path + ": no JSON"};
  return Table{listFrom<Rule>(json.at("rules")), listFrom<Scene>(json.at("scenes"))};
}

Status countLog(const std::string& path, RuleCounter& counter) {
  counter.beginRobot();
  return eachAgentFrame(path, [&](const FrameInput&, const FrameOutput& output) {
    counter.frame(output.command.trace);
  });
}

Status countMatch(const cli::SessionOptions& session, RuleCounter& counter) {
  Status read = Done{};
  cli::SessionTalk talk;
  talk.line = [](const std::string&) {};  // of a ball that is taken away and brought back
  talk.all = [&](const std::vector<std::string>& logs, const std::string&) {
    for (const std::string& log : logs)
      if (read) read = countLog(log, counter);
  };
  const cli::SessionResult result = cli::runSession(session, talk);
  if (cli::interrupted()) return Error{"interrupted"};
  if (!result.trouble.empty()) return Error{result.trouble};
  return read;
}

Expected<cli::SessionOptions> thesisSession(const Request& request, const Trial& trial,
                                            const std::string& robots) {
  auto plan = cli::teamPlan(robots);
  if (!plan) return Error{plan.error()};
  plan->redFolder = plan->blueFolder = sideOr("", "thesis");
  cli::SessionOptions session = sessionOf(request, trial);
  session.seconds = request.minutes > 0.0 ? 60.0 * request.minutes : kSeconds;
  session.goals = 99;
  session.keepFrames = session.keepAll = true;
  const Status used = cli::useTeams(*plan, session);
  if (!used) return Error{used.error()};
  return session;
}

// A try that came to nothing is made again.
void repeat(const Scene& scene, sim::Staging& staging) {
  const sim::Staging once = staging;
  for (double later = scene.again; later > 0.0 && later < scene.seconds; later += scene.again) {
    for (sim::BallThrow thrown : once.throws)
      if ((thrown.time += later) < scene.seconds) staging.throws.push_back(thrown);
    for (sim::RobotCarry carry : once.carries)
      if ((carry.time += later) < scene.seconds) staging.carries.push_back(carry);
  }
}

Status countScene(const Request& request, const Trial& trial, const Scene& scene,
                  RuleCounter& counter) {
  auto session = thesisSession(request, trial, scene.robots);
  if (!session) return Error{session.error()};
  auto staging =
      sim::stagingFrom({scene.places, scene.ball, scene.throws, scene.takes, scene.carries});
  if (!staging) return Error{staging.error()};
  session->rules = false;
  session->physical = session->physical || scene.physical;
  repeat(scene, *staging);
  session->staging = *staging;
  session->seconds = scene.seconds;
  if (!scene.params.empty()) session->params.push_back(besideThis(scene.params));
  session->set.insert(session->set.end(), scene.set.begin(), scene.set.end());
  for (cli::OtherRobot& robot : session->others) {
    robot.set.insert(robot.set.end(), scene.set.begin(), scene.set.end());
    if (robot.player == 1)
      robot.set.insert(robot.set.end(), scene.keeper.begin(), scene.keeper.end());
  }
  for (const std::string& words : scene.standing) {
    const auto place = sim::placeFrom(words);
    if (!place) return Error{place.error()};
    addStanding(place->pose, *session, place->robot.player);
  }
  return countMatch(*session, counter);
}

struct Counted {
  std::vector<int> times;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("times", &Counted::times));
  }
};

Counted countedBy(const RuleCounter& counter) {
  Counted counted;
  for (const Plays& plays : counter.plays()) counted.times.push_back(plays.times);
  return counted;
}

// The challenge of 2004 runs in a process of its own: one holds one Python interpreter.
Expected<Counted> countChallenge(const Request& request, const Trial& trial,
                                 const std::vector<Rule>& rules) {
  Request once = request;
  once.trials = 1;
  once.seed = trial.seed;
  once.params.push_back(sideOr("", "thesis") + "/team.toml");
  const auto config = agentConfig(once);
  if (!config) return Error{config.error()};
  const auto found = trialsInChildProcesses(once, [&](const Trial& one) -> Expected<Counted> {
    RuleCounter counter(rules);
    ChallengeWatch watch;
    watch.frame = [&](const WatchedFrame& frame) { counter.frame(frame.output.command.trace); };
    const Challenge challenge = challengeOf(config->field, one.seed);
    const Status played = playChallenge({*config, one.seed, once.randomised}, challenge, watch);
    if (!played) return Error{played.error()};
    return countedBy(counter);
  });
  if (!found) return Error{found.error()};
  return found->front();
}

Expected<Counted> countIn(const Request& request, const Trial& trial, const Scene& scene,
                          const std::vector<Rule>& rules) {
  if (scene.name == kChallenge) return countChallenge(request, trial, rules);
  RuleCounter counter(rules);
  const Status played = countScene(request, trial, scene, counter);
  if (!played) return Error{"scene " + scene.name + ": " + played.error()};
  return countedBy(counter);
}

void add(const Counted& more, std::vector<int>& sum) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += more.times[i];
}

// What all trials together counted; the first number of a row is of the matches, the second of its
// scene.
struct Found {
  std::vector<int> match, scene;
};

// Whether a row of the scene has come neither in a match nor in the scene.
bool isWanted(const Table& table, const Scene& scene, const Found& found) {
  for (std::size_t i = 0; i < table.rules.size(); ++i)
    if (table.rules[i].scene == scene.name && found.match[i] == 0 && found.scene[i] == 0)
      return true;
  return false;
}

Status stage(const Request& request, const Trial& trial, const Scene& scene, const Table& table,
             Found& found) {
  for (int i = 0; i < kTries && isWanted(table, scene, found); ++i) {
    const Trial one{trial.number, trial.seed + kSeedStep * static_cast<std::uint64_t>(i)};
    const auto counted = countIn(request, one, scene, table.rules);
    if (!counted) return Error{counted.error()};
    for (std::size_t row = 0; row < table.rules.size(); ++row)
      if (table.rules[row].scene == scene.name) found.scene[row] += counted->times[row];
  }
  return Done{};
}

Status countTrial(const Request& request, const Trial& trial, const Table& table, Found& found) {
  const auto session = thesisSession(request, trial, "4v4");
  if (!session) return Error{session.error()};
  RuleCounter counter(table.rules);
  const Status played = countMatch(*session, counter);
  if (!played) return played;
  add(countedBy(counter), found.match);
  for (const Scene& scene : table.scenes) {
    const Status staged = stage(request, trial, scene, table, found);
    if (!staged) return staged;
  }
  return Done{};
}

Json figuresOf(const Table& table, const Found& found, int trials) {
  Json rows = Json::array();
  Json never = Json::array();
  int played = 0;
  int staged = 0;
  int others = 0;
  for (std::size_t i = 0; i < table.rules.size(); ++i) {
    const Rule& rule = table.rules[i];
    Json row{{"id", rule.id}, {"rule", rule.rule}};
    if (rule.steps.empty()) {
      row["not_played"] = rule.unplayed;
      ++others;
    } else {
      row["times_per_match"] = ratio(found.match[i], trials);
      if (found.match[i] == 0) row["scene"] = rule.scene;
      if (found.match[i] == 0) row["times_in_scene"] = found.scene[i];
      played += found.match[i] > 0 ? 1 : 0;
      staged += found.match[i] == 0 && found.scene[i] > 0 ? 1 : 0;
      if (found.match[i] == 0 && found.scene[i] == 0) never.push_back(rule.id);
    }
    rows.push_back(row);
  }
  return Json{{"played_in_match", played},
              {"played_in_scene_only", staged},
              {"played_nowhere", never.size()},
              {"not_of_this_team", others},
              {"nowhere", never},
              {"rows", rows}};
}

// On how many seeds each row's scene, played once, brings it.
Json seedsOf(const Table& table, const std::vector<int>& seeds, int trials) {
  Json rows = Json::array();
  int fewest = trials;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const Rule& rule = table.rules[i];
    if (rule.scene.empty()) continue;
    rows.push_back({{"id", rule.id}, {"scene", rule.scene}, {"seeds_with_it", seeds[i]}});
    fewest = std::min(fewest, seeds[i]);
  }
  return Json{{"fewest_seeds_with_a_row", fewest}, {"rows", rows}};
}

Status countSeed(const Request& request, const Trial& trial, const Table& table,
                 std::vector<int>& seeds) {
  for (const Scene& scene : table.scenes) {
    const auto counted = countIn(request, trial, scene, table.rules);
    if (!counted) return Error{counted.error()};
    for (std::size_t i = 0; i < seeds.size(); ++i)
      if (table.rules[i].scene == scene.name) seeds[i] += counted->times[i] > 0 ? 1 : 0;
  }
  return Done{};
}

Expected<Json> thesisScenes(const Request& request) {
  cli::catchInterrupts();
  const auto table = readTable();
  if (!table) return Error{table.error()};
  std::vector<int> seeds(table->rules.size());
  const Status counted = eachTrial(
      request, [&](const Trial& trial) { return countSeed(request, trial, *table, seeds); });
  if (!counted) return Error{counted.error()};
  return seedsOf(*table, seeds, request.trials);
}

Expected<Json> thesisRules(const Request& request) {
  cli::catchInterrupts();
  const auto table = readTable();
  if (!table) return Error{table.error()};
  Found found{std::vector<int>(table->rules.size()), std::vector<int>(table->rules.size())};
  const Status counted = eachTrial(
      request, [&](const Trial& trial) { return countTrial(request, trial, *table, found); });
  if (!counted) return Error{counted.error()};
  return figuresOf(*table, found, request.trials);
}

const Registration kThesisRules("thesis-rules", "how often the theses' team plays each rule",
                                {Option::trials, Option::seed, Option::params, Option::fast,
                                 Option::minutes},
                                1, thesisRules);
const Registration kThesisScenes("thesis-scenes",
                                 "on how many seeds a staged scene brings the thesis' rule",
                                 {Option::trials, Option::seed, Option::params, Option::fast}, 20,
                                 thesisScenes);

}  // namespace
}  // namespace kelpie::experiments
