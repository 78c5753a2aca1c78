// SPDX-License-Identifier: Apache-2.0
// An experiment measures the whole or a part of the robot and answers with plain numbers under
// snake_case keys that end in their unit. The same trials and seed give the same figures.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/cli/Figures.h"

namespace kelpie::experiments {

using cli::Json;
using cli::percentile;

struct ExperimentOptions {
  int trials = 0;  // 0: the experiment's own number
  std::uint64_t seed = 1;
  std::string pictures;             // a folder for pictures of what went wrong; empty: none
  std::vector<std::string> params;  // the agent's TOML files, for experiments that play
  std::function<void(int done, int all)> progress;
};

struct Experiment {
  const char* name;
  const char* measures;  // one line for --list
  int trials;            // when none are asked for
  Expected<Json> (*run)(const ExperimentOptions& options);
};

const std::vector<Experiment>& experiments();

Expected<Json> scoreEmptyGoal(const ExperimentOptions& options);
Expected<Json> walkAndKick(const ExperimentOptions& options);
Expected<Json> classPlanes(const ExperimentOptions& options);
Expected<Json> distances(const ExperimentOptions& options);
Expected<Json> localiseObservations(const ExperimentOptions& options);
Expected<Json> maximiser(const ExperimentOptions& options);
Expected<Json> stationaryMap(const ExperimentOptions& options);
Expected<Json> stationaryViews(const ExperimentOptions& options);
Expected<Json> globalLocalise(const ExperimentOptions& options);
Expected<Json> modeSampling(const ExperimentOptions& options);
Expected<Json> linePoints(const ExperimentOptions& options);
Expected<Json> pinkPatches(const ExperimentOptions& options);
Expected<Json> obstaclesAhead(const ExperimentOptions& options);
Expected<Json> robots(const ExperimentOptions& options);
Expected<Json> projection(const ExperimentOptions& options);
Expected<Json> doubts(const ExperimentOptions& options);
Expected<Json> objects(const ExperimentOptions& options);
Expected<Json> fieldEdge(const ExperimentOptions& options);
Expected<Json> colour(const ExperimentOptions& options);
Expected<Json> kidnap(const ExperimentOptions& options);
Expected<Json> localise(const ExperimentOptions& options);
Expected<Json> slam(const ExperimentOptions& options);
Expected<Json> ring(const ExperimentOptions& options);
Expected<Json> ballFilter(const ExperimentOptions& options);
Expected<Json> opponents(const ExperimentOptions& options);
Expected<Json> teamBall(const ExperimentOptions& options);
Expected<Json> stuck(const ExperimentOptions& options);

}  // namespace kelpie::experiments
