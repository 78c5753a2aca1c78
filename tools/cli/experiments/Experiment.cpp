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
      {"line-points",
       "points on lines, border and carpet in random views with every artefact: share that is "
       "true, error on the ground by distance, share of the visible crossings found",
       400, linePoints},
      {"projection",
       "a grid of ground discs rendered and found again in the image, against its projection: "
       "largest error in pixels, and on the ground at 1 m",
       500, projection},
      {"objects",
       "rendered random views with every artefact and spectators: recall, false percepts, errors "
       "of "
       "distance and heading by object and distance",
       3000, objects},
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
