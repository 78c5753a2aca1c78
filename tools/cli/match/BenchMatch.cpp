// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/match/BenchMatch.h"

#include <fmt/core.h>

#include <chrono>
#include <ctime>
#include <vector>

#include "tools/cli/Process.h"
#include "tools/cli/RunDirectory.h"
#include "tools/learn/walk/PhysicalWalker.h"

namespace kelpie::cli {
namespace {

constexpr double kWarm = 1.0;        // s of a match that is only begun
constexpr double kWalked = 30.0;     // s of the one robot
constexpr double kOneCommand = 1.0;  // s

double physicsOfOne(std::uint64_t seed) {
  constexpr double kMessage = kTickSeconds * kTicksPerMessage;
  const actuator::ActuatorParams params;
  learn::PhysicalWalker walker({}, params, seed);
  Random random(seed);
  Command command;
  const std::clock_t begin = std::clock();
  for (int i = 0; i * kMessage < kWalked; ++i) {
    if (i % static_cast<int>(kOneCommand / kMessage) == 0)
      command.walk = {random.uniform(-20, 30), random.uniform(-15, 15), random.uniform(-1.5, 1.5)};
    walker.step(command);
  }
  return kWalked * CLOCKS_PER_SEC / static_cast<double>(std::clock() - begin);
}

std::vector<std::string> worldOf(const MatchBench& bench, double seconds,
                                 const RunDirectory& runDirectory) {
  return {programFolder() + "/kelpie-world",
          "--socket",
          runDirectory.path("world"),
          "--robots",
          std::to_string(bench.robots),
          "--seed",
          std::to_string(bench.seed),
          "--scenario",
          "kickoff",
          "--goals",
          "0",
          "--seconds",
          fmt::format("{}", seconds),
          bench.physical ? "--physical" : "--fast"};
}

std::vector<std::string> agentOf(const MatchBench& bench, int robot,
                                 const RunDirectory& runDirectory) {
  return {programFolder() + "/kelpie-agent",
          "--socket",
          runDirectory.path("world"),
          "--team",
          robot % 2 == 0 ? "red" : "blue",
          "--player",
          std::to_string(robot / 2 + 1),
          "--seed",
          std::to_string(bench.seed + static_cast<std::uint64_t>(robot)),
          bench.physical ? "--physical" : "--fast"};
}

// Seconds of the clock from the first process to the last one's end.
Expected<double> played(const MatchBench& bench, double seconds) {
  const RunDirectory runDirectory;
  if (!runDirectory.ready()) return Error{"cannot make a temporary folder"};
  const auto begin = std::chrono::steady_clock::now();
  auto world = Process::start(worldOf(bench, seconds, runDirectory), false);
  if (!world) return Error{world.error()};
  std::vector<Process> agents;
  for (int robot = 0; robot < bench.robots; ++robot) {
    auto agent = Process::start(agentOf(bench, robot, runDirectory), false);
    if (!agent) return Error{agent.error()};
    agents.push_back(std::move(*agent));
  }
  const int code = world->wait();
  for (Process& agent : agents) agent.wait();
  if (code != 0) return Error{fmt::format("the world stopped with code {}", code)};
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

Expected<MatchSpeeds> benchMatch(const MatchBench& bench) {
  const auto begun = played(bench, kWarm);
  if (!begun) return Error{begun.error()};
  const auto whole = played(bench, kWarm + bench.seconds);
  if (!whole) return Error{whole.error()};
  return MatchSpeeds{physicsOfOne(bench.seed), bench.seconds / (*whole - *begun)};
}

}  // namespace kelpie::cli
