// SPDX-License-Identifier: Apache-2.0
// How soon a ball is free again at which two robots push: beside a post with the goalie, and in a
// corner. Free is a ball that is 50 cm from where it lay, out, or in the goal. It does not tell who
// freed it, nor whether it was worth it.
#include <array>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/scenes/StagedScenes.h"

namespace kelpie::experiments {
namespace {

constexpr double kFree = 50.0;  // cm
constexpr double kSoon = 6.0;   // s

double freeAfter(const Played& played) {
  if (played.moments.empty()) return kNever;
  const PlayedMoment& first = played.moments.front();
  const double out = played.outAfter(first.seconds()).value_or(kNever);
  for (const PlayedMoment& moment : played.moments)
    if (moment.seconds() >= out || distance(moment.truth.ball, first.truth.ball) >= kFree)
      return moment.seconds() - first.seconds();
  return out < kNever ? out - first.seconds() : kNever;
}

struct Freed {
  Share soon;
  Values after;
};

Expected<Json> stalemate(const Request& request) {
  std::array<Freed, 2> found;
  StagedScenes scenes;
  scenes.kinds = {"post", "jam"};
  scenes.opponents = "thesis";
  scenes.judge = [&](std::size_t kind, const Played& played) {
    const double after = freeAfter(played);
    found[kind].soon.count(after <= kSoon);
    found[kind].after.push_back(after);
  };
  const Status done = playScenes(request, scenes);
  if (!done) return Error{done.error()};
  Share both = found[0].soon;
  both.add(found[1].soon);
  return Json{{"free_within_6s_share", both.value()},
              {"post_within_6s_share", found[0].soon.value()},
              {"post_median_s", percentile(found[0].after, 0.5)},
              {"corner_within_6s_share", found[1].soon.value()},
              {"corner_median_s", percentile(found[1].after, 0.5)}};
}

const Registration kStalemate(
    "stalemate", "a ball at which two push, at a post and in a corner: how soon it is free",
    {Option::trials, Option::seed, Option::fast, Option::side, Option::opponents}, 50, stalemate);

}  // namespace
}  // namespace kelpie::experiments
