// SPDX-License-Identifier: Apache-2.0
// How much the map of a standing robot helps: the pose after five seconds of standing and looking
// about, from a start known within 40 cm and 20 deg, on lines alone, with the map and without; and
// from no start at all by the search on the map. One landmark-free stand cannot tell a pose from
// its twin, so the search is compared with the nearer of both.
#include <algorithm>
#include <vector>

#include "gps/lines/LineMap.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/harness/Trials.h"
#include "tools/experiments/pose/LocaliseFilters.h"
#include "tools/sim/world/LocalisingRobot.h"

namespace kelpie::experiments {
namespace {

constexpr int kFrames = 150;
constexpr double kWithinCm = 10.0;  // checklist M38

struct Stands {
  ErrorTrack errors;
  Values points;  // in the map, after five seconds
  Values lines;
};

void stand(sim::StandingRobot& robot, bool search, Stands& stands) {
  WorldModel world;
  for (int i = 0; i < kFrames; ++i) {
    robot.input.lastCommand.localise = search;
    robot.look(false);
    world = robot.step();
  }
  const PoseError here = poseError(world, robot.truth.pose());
  const PoseError twin = poseError(world, robot.twin());
  stands.errors.add(search && twin.cm < here.cm ? twin : here);
  const gps::LineMap& map = robot.state.lines.map;
  stands.points.push_back(static_cast<double>(map.points.size()));
  stands.lines.push_back(static_cast<double>(gps::countOf(map, LinePointKind::line)));
}

void addFigures(const std::string& prefix, const Stands& stands, Json& json) {
  const Json all = stands.errors.summary();
  for (const char* key : {"mean_cm", "median_cm", "p95_cm", "mean_deg", "nees", "nees_mean"})
    json[prefix + key] = all[key];
  json[prefix + "within_10_cm_rate"] = shareUpTo(stands.errors.cm, kWithinCm);
}

Expected<Json> stationaryMap(const Request& request) {
  Stands with, without, searched;
  eachTrial(request, [&](const Trial& trial) {
    for (const bool map : {true, false}) {
      sim::StandingRobot robot(trial.seed);
      robot.params.lines.map.use = map;
      robot.believeCoarsely();
      stand(robot, false, map ? with : without);
    }
    sim::StandingRobot lost(trial.seed);
    stand(lost, true, searched);
  });
  Json json;
  addFigures("", with, json);
  json["points_mean"] = mean(with.points);
  json["points_min"] = *std::min_element(with.points.begin(), with.points.end());
  json["points_max"] = *std::max_element(with.points.begin(), with.points.end());
  json["line_points_mean"] = mean(with.lines);
  addFigures("without_map_", without, json);
  addFigures("search_", searched, json);
  return json;
}

const Registration kStationaryMap(
    "stationary-map", "standing, lines alone: errors with the map, without it and by the search",
    {Option::trials, Option::seed}, 200, stationaryMap);

}  // namespace
}  // namespace kelpie::experiments
