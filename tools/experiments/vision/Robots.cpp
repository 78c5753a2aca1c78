// SPDX-License-Identifier: Apache-2.0
// Robots in random views: which of those that can be seen vision finds, how far off it places them,
// and where it finds one that is not there.
#include <array>
#include <cmath>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/views/Looks.h"
#include "tools/experiments/views/SeenRobots.h"

namespace kelpie::experiments {
namespace {

constexpr double kMaxDistance = 200.0;  // cm, of a robot that must be seen
constexpr double kMinShare = 0.6;       // of its pixels
constexpr double kGate = 12.0;          // deg between a percept and a robot of which it can be
constexpr double kPatchPixels = 12.0;   // of uniform: three samples of the lattice

struct Tally {
  int views = 0;
  Share found;                   // of the robots that must be seen
  std::array<Share, 2> foundOf;  // the same by team
  Share patched;                 // of those, with enough of their uniform in view
  Share patchedFound;
  int matched = 0;  // percepts of any robot
  int wrongTeam = 0;
  int doubles = 0;  // further percepts of a robot that has one
  int falseOnes = 0;
  Values heading;   // deg, of the robots due
  Values distance;  // share of the true one, of the robots due
  Values spread;    // error over the standard deviation that vision gives
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
  return robot.distance <= kMaxDistance && robot.share >= kMinShare;
}

void addErrors(const RobotPercept& percept, const SeenRobot& robot, Tally& tally) {
  if (percept.team != robot.team) ++tally.wrongTeam;
  if (!isDue(robot)) return;
  tally.heading.push_back((percept.heading - robot.heading).deg());
  tally.distance.push_back(percept.distance / robot.distance - 1.0);
  tally.spread.push_back((percept.distance - robot.distance) / std::sqrt(percept.distanceVariance));
}

void addView(const Percepts& percepts, const std::vector<SeenRobot>& seen, Tally& tally) {
  std::vector<int> hits(seen.size(), 0);
  for (const RobotPercept& percept : percepts.robots) {
    const Match match = matchOf(percept, seen);
    if (match.robot < 0) {
      ++tally.falseOnes;
      continue;
    }
    const auto at = static_cast<std::size_t>(match.robot);
    ++tally.matched;
    if (hits[at]++ > 0) {
      ++tally.doubles;
    } else {
      addErrors(percept, seen[at], tally);
    }
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!isDue(seen[i])) continue;
    const bool found = hits[i] > 0;
    const bool patched = seen[i].patchPixels >= kPatchPixels;
    tally.found.count(found);
    tally.foundOf[static_cast<std::size_t>(seen[i].team)].count(found);
    tally.patched.count(patched);
    if (patched) tally.patchedFound.count(found);
  }
}

Json figures(const Tally& tally) {
  const double views = tally.views;
  return Json{{"due_count", tally.found.all},
              {"recall_rate", tally.found.value()},
              {"recall_red_rate", tally.foundOf[0].value()},
              {"recall_blue_rate", tally.foundOf[1].value()},
              {"patch_in_view_rate", tally.patched.value()},
              {"recall_with_patch_rate", tally.patchedFound.value()},
              {"heading_rms_deg", rms(tally.heading)},
              {"heading_median_deg", percentile(tally.heading, 0.5)},
              {"distance_rms_rate", rms(tally.distance)},
              {"distance_median_rate", percentile(tally.distance, 0.5)},
              {"distance_rms_sd", rms(tally.spread)},
              {"false_per_1000_views", 1000.0 * tally.falseOnes / views},
              {"double_per_1000_views", 1000.0 * tally.doubles / views},
              {"wrong_team_rate", ratio(tally.wrongTeam, tally.matched)}};
}

Expected<Json> robots(const Request& request) {
  Tally tally;
  lookAtViews({}, request, [&tally](const Look& look) {
    addView(look.seen, seenRobots(look.view), tally);
    ++tally.views;
  });
  return figures(tally);
}

const Registration kRobots(
    "robots", "other robots in views: recall to 200 cm, errors, false ones, wrong teams",
    {Option::trials, Option::seed, Option::randomised}, 400, robots);

}  // namespace
}  // namespace kelpie::experiments
