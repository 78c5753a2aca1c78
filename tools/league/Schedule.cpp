// SPDX-License-Identifier: Apache-2.0
#include "tools/league/Schedule.h"

#include <algorithm>
#include <cmath>

namespace kelpie::league {
namespace {

constexpr std::uint64_t kLargestSeed = 9000000000000000ULL;  // whole numbers a double can hold
constexpr int kMaxMatchesAPair = 1000000;
constexpr std::size_t kMaxSides = 1000;

// Tables, pictures and pages take such names as they are.
bool isName(const std::string& name) {
  const auto printable = [](char c) { return c >= ' ' && c <= '~'; };
  return !name.empty() && name.size() <= kLongestName && name.front() != ' ' &&
         name.back() != ' ' && std::all_of(name.begin(), name.end(), printable);
}

Status checkSides(const LeaguePlan& plan) {
  const auto& sides = plan.sides;
  if (sides.size() < 2) return Error{"a league needs two sides at least"};
  if (sides.size() > kMaxSides) return Error{"a league takes 1000 sides at most"};
  for (auto side = sides.begin(); side != sides.end(); ++side) {
    if (!isName(*side))
      return Error{"side '" + *side + "': a name is 1 to 40 printable ASCII characters"};
    if (std::find(sides.begin(), side, *side) != side)
      return Error{"side '" + *side + "': named twice"};
  }
  const bool known = std::find(sides.begin(), sides.end(), plan.reference) != sides.end();
  if (!plan.reference.empty() && !known)
    return Error{"reference '" + plan.reference + "': none of the sides"};
  return Done{};
}

}  // namespace

std::vector<Pairing> pairingsOf(const LeaguePlan& plan) {
  std::vector<Pairing> pairings;
  const auto& sides = plan.sides;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t k = i + 1; k < sides.size(); ++k)
      if (plan.reference.empty() || plan.reference == sides[i] || plan.reference == sides[k])
        pairings.push_back({i, k});
  return pairings;
}

Status checkPlan(const LeaguePlan& plan) {
  const Status sides = checkSides(plan);
  if (!sides) return sides;
  if (plan.matchesAPair < 2 || plan.matchesAPair % 2 != 0 || plan.matchesAPair > kMaxMatchesAPair)
    return Error{"matches a pair: an even number from 2 to 1000000, each seed being played twice"};
  if (!(plan.minutes > 0.0) || !std::isfinite(plan.minutes))
    return Error{"minutes of a match: more than 0"};
  if (plan.seed > kLargestSeed) return Error{"seed: at most 9e15"};
  return Done{};
}

std::vector<ScheduledMatch> scheduleOf(const LeaguePlan& plan) {
  const auto pairings = pairingsOf(plan);
  std::vector<ScheduledMatch> schedule;
  for (int draw = 0; draw < plan.matchesAPair / 2; ++draw)
    for (std::size_t i = 0; i < pairings.size(); ++i)
      for (const bool exchanged : {false, true}) {
        const std::string& first = plan.sides[pairings[i].first];
        const std::string& second = plan.sides[pairings[i].second];
        const std::uint64_t seed = plan.seed + static_cast<std::uint64_t>(draw);
        schedule.push_back({i,
                            draw,
                            exchanged,
                            {exchanged ? second : first, exchanged ? first : second, seed,
                             plan.minutes, plan.fast}});
      }
  return schedule;
}

}  // namespace kelpie::league
