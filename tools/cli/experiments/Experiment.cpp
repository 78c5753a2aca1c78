// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/experiments/Experiment.h"

#include <algorithm>

namespace kelpie::cli {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> kAll = {
      {"score-empty-goal",
       "one robot, unknown start, ball at random, no opponent: share of trials with a goal within "
       "60 s, median time to it; every camera artefact on",
       20, scoreEmptyGoal},
      {"projection",
       "a grid of ground discs rendered and found again in the image, against its projection: "
       "largest error in pixels, and on the ground at 1 m",
       500, projection},
      {"robots",
       "other robots in random views with spectators: recall to 200 cm, errors of heading and "
       "distance, false ones and wrong teams",
       400, robots},
      {"pink-patches",
       "pink sheets on the carpet in random views: recall, errors of heading and distance, false "
       "ones without a sheet",
       400, pinkPatches},
      {"obstacles-ahead",
       "dark pixels in the box ahead against a robot's true presence: hits and false alarms by "
       "threshold",
       3000, obstaclesAhead},
      {"walk-and-kick",
       "the actuator in the simulated body: true way over reported way in four directions; how far "
       "and how straight the ball goes from 25 places before the chest",
       1, walkAndKick},
  };
  return kAll;
}

double percentile(std::vector<double> values, double p) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const double place = p * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  const double share = place - static_cast<double>(below);
  return values[below] + share * (values[above] - values[below]);
}

}  // namespace kelpie::cli
