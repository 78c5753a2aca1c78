// SPDX-License-Identifier: Apache-2.0
// Robots in random views: which of those that can be seen vision finds, how far off it places them,
// and what it takes for a robot that is none.
#include <array>
#include <cmath>

#include "tools/experiments/Experiment.h"
#include "tools/experiments/Looks.h"
#include "tools/experiments/SeenRobots.h"

namespace kelpie::experiments {
namespace {

constexpr double kFarthest = 200.0;    // cm, of a robot that must be seen
constexpr double kMinShare = 0.6;      // of its pixels
constexpr double kGate = 12.0;         // deg between a percept and a robot of which it can be
constexpr double kPatchPixels = 12.0;  // of uniform: three samples of the lattice

struct Tally {
  int views = 0;
  int due = 0;  // robots that must be seen
  int found = 0;
  int patched = 0;  // of those due, with enough of their uniform in view
  int patchedFound = 0;
  int matched = 0;  // percepts of any robot
  int wrongTeam = 0;
  int doubles = 0;  // further percepts of a robot that has one
  int falses = 0;
  std::array<int, 2> dueOf{};
  std::array<int, 2> foundOf{};
  std::vector<double> heading;   // deg, of the robots due
  std::vector<double> distance;  // share of the true one, of the robots due
  std::vector<double> spread;    // error over the standard deviation that vision gives
};

struct Match {
  int robot = -1;
  double off = 1e9;  // deg
};

// The seen robot in whose direction a percept lies.
Match matchOf(const RobotPercept& percept, const std::vector<SeenRobot>& seen) {
  Match best;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double half = 14.0 / std::fmax(seen[i].distance, 14.0) * 57.3;
    const double off = std::fabs((percept.heading - seen[i].heading).deg());
    const double ratio = percept.distance / seen[i].distance;
    if (off > std::fmax(kGate, half) || ratio > 2.0 || ratio < 0.4) continue;
    if (off < best.off) best = {static_cast<int>(i), off};
  }
  return best;
}

bool isDue(const SeenRobot& robot) {
  return robot.distance <= kFarthest && robot.share >= kMinShare;
}

void judgeFound(const RobotPercept& percept, const SeenRobot& robot, Tally& tally) {
  if (percept.team != robot.team) ++tally.wrongTeam;
  if (!isDue(robot)) return;
  tally.heading.push_back((percept.heading - robot.heading).deg());
  tally.distance.push_back(percept.distance / robot.distance - 1.0);
  tally.spread.push_back((percept.distance - robot.distance) / std::sqrt(percept.distanceVariance));
}

void judge(const Percepts& percepts, const std::vector<SeenRobot>& seen, Tally& tally) {
  std::vector<int> hits(seen.size(), 0);
  for (const RobotPercept& percept : percepts.robots) {
    const Match match = matchOf(percept, seen);
    if (match.robot < 0) {
      ++tally.falses;
      continue;
    }
    const auto at = static_cast<std::size_t>(match.robot);
    ++tally.matched;
    if (hits[at]++ > 0) {
      ++tally.doubles;
    } else {
      judgeFound(percept, seen[at], tally);
    }
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!isDue(seen[i])) continue;
    const int hit = hits[i] > 0 ? 1 : 0;
    const bool patched = seen[i].patchPixels >= kPatchPixels;
    ++tally.due;
    tally.found += hit;
    tally.patched += patched ? 1 : 0;
    tally.patchedFound += patched ? hit : 0;
    ++tally.dueOf[static_cast<std::size_t>(seen[i].team)];
    tally.foundOf[static_cast<std::size_t>(seen[i].team)] += hit;
  }
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v * v;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

double share(int part, int whole) { return whole > 0 ? static_cast<double>(part) / whole : 0.0; }

Json figures(const Tally& tally, const ExperimentOptions& options) {
  const double views = tally.views;
  return Json{{"experiment", "robots"},
              {"trials", options.trials},
              {"seed", options.seed},
              {"due_count", tally.due},
              {"recall_rate", share(tally.found, tally.due)},
              {"recall_red_rate", share(tally.foundOf[0], tally.dueOf[0])},
              {"recall_blue_rate", share(tally.foundOf[1], tally.dueOf[1])},
              {"patch_in_view_rate", share(tally.patched, tally.due)},
              {"recall_with_patch_rate", share(tally.patchedFound, tally.patched)},
              {"heading_rms_deg", rms(tally.heading)},
              {"heading_median_deg", percentile(tally.heading, 0.5)},
              {"distance_rms_rate", rms(tally.distance)},
              {"distance_median_rate", percentile(tally.distance, 0.5)},
              {"distance_rms_sd", rms(tally.spread)},
              {"false_per_1000_views", 1000.0 * tally.falses / views},
              {"double_per_1000_views", 1000.0 * tally.doubles / views},
              {"wrong_team_rate", share(tally.wrongTeam, tally.matched)}};
}

}  // namespace

Expected<Json> robots(const ExperimentOptions& options) {
  ViewParams params;
  params.field = *body::fieldDescription("2006");
  Tally tally;
  lookAtViews(params, options, [&tally](const Look& look) {
    judge(look.seen, seenRobots(look.view), tally);
    ++tally.views;
  });
  return figures(tally, options);
}

}  // namespace kelpie::experiments
