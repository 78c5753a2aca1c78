// SPDX-License-Identifier: Apache-2.0
// Whether a team (--a) scores from close by: the ball within 60 cm of a goal that a defender and
// the goalie of the other team (--b) keep, and within 15 cm of a line that nobody keeps.
#include <array>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/scenes/StagedScenes.h"

namespace kelpie::experiments {
namespace {

struct Finished {
  Share scored, conceded;
  Values after;  // s, of the goals
};

void judge(const Played& played, Finished& finished) {
  const auto scored = goalAfter(played, TeamColour::red);
  finished.scored.count(scored.has_value());
  finished.conceded.count(goalAfter(played, TeamColour::blue).has_value());
  if (scored) finished.after.push_back(*scored);
}

Expected<Json> finish(const Request& request) {
  std::array<Finished, 2> found;
  StagedScenes scenes;
  scenes.kinds = {"finish", "open-line"};
  scenes.opponents = "thesis";
  scenes.judge = [&](std::size_t kind, const Played& played) { judge(played, found[kind]); };
  const Status done = playScenes(request, scenes);
  if (!done) return Error{done.error()};
  return Json{{"goals", found[0].scored.value()},
              {"goals_against", found[0].conceded.value()},
              {"after_median_s", percentile(found[0].after, 0.5)},
              {"open_line_goals", found[1].scored.value()},
              {"open_line_after_median_s", percentile(found[1].after, 0.5)}};
}

const Registration kFinish(
    "finish", "a ball close to a goal, kept (--b) and open: how often --a scores",
    {Option::trials, Option::seed, Option::fast, Option::side, Option::opponents}, 100, finish);

}  // namespace
}  // namespace kelpie::experiments
