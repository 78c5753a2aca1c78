// SPDX-License-Identifier: Apache-2.0
// How fast eight robots play on this machine, cameras and all, and whether their processes grow: a
// match of two minutes with masses and servos, one of ten on kinematic bodies. A figure of this
// machine, while nothing else runs; no test depends on it.
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/team/TeamMatch.h"

namespace kelpie::experiments {
namespace {

namespace fs = std::filesystem;

constexpr double kPhysicalSeconds = 120.0;
constexpr double kFastSeconds = 600.0;
constexpr double kWarm = 0.2;  // share of a match after which nothing may grow any more

double since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// MB in memory of that process, when it is a child of this one.
double residentOf(const fs::path& process) {
  std::ifstream file(process / "stat");
  std::string all((std::istreambuf_iterator<char>(file)), {});
  const std::size_t name = all.rfind(')');
  if (name == std::string::npos) return 0.0;
  std::istringstream words(all.substr(name + 2));
  std::string word;
  long parent = 0, pages = 0;
  words >> word >> parent;
  for (int i = 0; i < 19; ++i) words >> word;  // up to vsize, field 23
  words >> pages;
  if (parent != getpid()) return 0.0;
  return 1e-6 * static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double residentOfChildren() {
  double all = 0.0;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator("/proc", error))
    if (entry.path().filename().string().find_first_not_of("0123456789") == std::string::npos)
      all += residentOf(entry.path());
  return all;
}

struct Measured {
  double speed = 0.0;  // simulated seconds a second
  Values resident;     // MB, once a second
  std::string trouble;
};

Measured measured(const Request& request, double seconds, bool physical) {
  cli::SessionOptions session = *teamSession(request, trialOf(request, 0), "4v4", seconds);
  session.physical = physical;
  session.keepAll = session.keepFrames = false;
  Measured found;
  const auto start = std::chrono::steady_clock::now();
  cli::SessionTalk talk;
  talk.over = [&] {
    if (since(start) > static_cast<double>(found.resident.size()))
      found.resident.push_back(residentOfChildren());
    return false;
  };
  const cli::SessionResult result = cli::runSession(session, talk);
  found.speed = result.seconds / since(start);
  found.trouble = result.trouble;
  return found;
}

// The most of the last fifth less the most of the second.
double growth(const Values& resident) {
  const auto part = static_cast<std::ptrdiff_t>(kWarm * static_cast<double>(resident.size()));
  if (part == 0) return 0.0;
  const Values early(resident.begin() + part, resident.begin() + 2 * part);
  const Values late(resident.end() - part, resident.end());
  return percentile(late, 1.0) - percentile(early, 1.0);
}

Expected<Json> matchSpeed(const Request& request) {
  const Measured physical = measured(request, kPhysicalSeconds, true);
  if (!physical.trouble.empty()) return Error{physical.trouble};
  const Measured fast = measured(request, kFastSeconds, false);
  if (!fast.trouble.empty()) return Error{fast.trouble};
  return Json{{"match_speed", physical.speed},
              {"fast_speed", fast.speed},
              {"growth_mb", growth(fast.resident)},
              {"resident_mb", percentile(fast.resident, 1.0)}};
}

const Registration kMatchSpeed("match-speed",
                               "eight robots with cameras: simulated seconds a second, growth",
                               {Option::seed, Option::params}, 1, matchSpeed);

}  // namespace
}  // namespace kelpie::experiments
