// SPDX-License-Identifier: Apache-2.0
#include "tools/session/Teams.h"

#include <algorithm>
#include <filesystem>

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

Status readFolder(const std::string& folder, OtherRobot& robot) {
  if (folder.empty()) return Done{};
  const bool scripts = fs::exists(folder + "/main.py");
  const bool params = fs::exists(folder + "/team.toml");
  if (!scripts && !params) return Error{"'" + folder + "': holds neither main.py nor team.toml"};
  if (scripts) robot.pycode = folder;
  if (params) robot.params.push_back(folder + "/team.toml");
  return Done{};
}

// Parameters of the command line are for all robots, a team's own come on top of them.
Status addTeam(const std::string& team, int count, const std::string& folder,
               const SessionOptions& all, std::vector<OtherRobot>& robots) {
  for (int player = 1; player <= count; ++player) {
    OtherRobot robot{team, player, all.pycode, all.params, all.set, all.seed};
    robot.seed += static_cast<std::uint64_t>(player) + (team == "red" ? 0U : 4U);
    const Status read = readFolder(folder, robot);
    if (!read) return read;
    if (player == 1 && count > 1) robot.set.emplace_back(kKeeps);
    robots.push_back(robot);
  }
  return Done{};
}

void watch(const OtherRobot& robot, SessionOptions& options) {
  options.team = robot.team;
  options.player = robot.player;
  options.pycode = robot.pycode;
  options.params = robot.params;
  options.set = robot.set;
}

// A team without robots cannot be watched; of strangers nobody knows what they believe.
std::string watchedTeam(const TeamPlan& plan, const SessionOptions& options) {
  const std::string other = options.team == "red" ? "blue" : "red";
  const auto count = [&](const std::string& team) { return team == "red" ? plan.red : plan.blue; };
  if (count(options.team) == 0) return other;
  const bool tells = options.strangerOf(options.team).empty();
  return tells || count(other) == 0 || !options.strangerOf(other).empty() ? options.team : other;
}

}  // namespace

Expected<TeamPlan> teamPlan(const std::string& robots) {
  const auto digit = [&](std::size_t at) { return robots[at] - '0'; };
  const auto isCount = [&](std::size_t at) { return digit(at) >= 0 && digit(at) <= 4; };
  if (robots.size() != 3 || robots[1] != 'v' || !isCount(0) || !isCount(2) || robots == "0v0")
    return Error{"'" + robots + "': teams are written as 4v4, with up to 4 robots a side"};
  return TeamPlan{digit(0), digit(2), "", ""};
}

Status useTeams(const TeamPlan& plan, SessionOptions& options) {
  std::vector<OtherRobot> robots;
  const Status red = addTeam("red", plan.red, plan.redFolder, options, robots);
  if (!red) return red;
  const Status blue = addTeam("blue", plan.blue, plan.blueFolder, options, robots);
  if (!blue) return blue;
  const std::string team = watchedTeam(plan, options);
  const int player = std::min(2, team == "red" ? plan.red : plan.blue);
  const auto watched = std::find_if(robots.begin(), robots.end(), [&](const OtherRobot& robot) {
    return robot.team == team && robot.player == player;
  });
  watch(*watched, options);
  robots.erase(watched);
  options.others = robots;
  options.scenario = "kickoff";
  options.rules = true;
  return Done{};
}

void useRules(const std::string& year, SessionOptions& options) {
  constexpr double kAnyWay = 500.0;  // cm, the most that the rules' table takes: in 3 s nobody does
  if (year != "2005") return;
  options.holdingDistance = kAnyWay;
  options.set.push_back("field.rules.holdingDistance=" + std::to_string(kAnyWay) + "cm");
}

std::vector<host::AgentHello> robotsOf(const SessionOptions& options) {
  const auto hello = [](const std::string& team, int player) {
    return host::AgentHello{team == "red" ? TeamColour::red : TeamColour::blue,
                            static_cast<std::uint8_t>(player)};
  };
  std::vector<host::AgentHello> robots = {hello(options.team, options.player)};
  for (const OtherRobot& other : options.others) robots.push_back(hello(other.team, other.player));
  return robots;
}

}  // namespace kelpie::cli
