// SPDX-License-Identifier: Apache-2.0
#include "tools/match/Highlights.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kelpie::match {
namespace {

// Two moments closer than this share of the match tell the same story: first the wider one, then,
// where there are too few so far apart, the narrower.
constexpr std::array<double, 2> kApartShares = {0.09, 0.04};
constexpr double kMinSeconds = 0.4;  // and at least so much
constexpr double kRepeated = 3.0;    // by how much less each repetition of a kind counts

double weightOf(HappeningKind kind) {
  switch (kind) {
    case HappeningKind::goal: return 20.0;
    case HappeningKind::kick: return 9.0;
    case HappeningKind::hold: return 8.5;
    case HappeningKind::sight: return 8.0;
    case HappeningKind::fall: return 6.0;
    case HappeningKind::call: return 5.0;
    case HappeningKind::found: return 4.0;
    case HappeningKind::notice: return 1.5;
    case HappeningKind::lost: return 1.0;
    default: return 0.0;
  }
}

// A kick that a goal follows within this time counts more than any other.
constexpr double kBeforeGoal = 6.0;  // s
constexpr double kLeadsToGoal = 6.0;

bool leadsToGoal(const Happening& one, const std::vector<Happening>& all) {
  const bool may = one.kind == HappeningKind::kick || one.kind == HappeningKind::hold;
  return may && std::any_of(all.begin(), all.end(), [&](const Happening& other) {
           return other.kind == HappeningKind::goal && other.seconds >= one.seconds &&
                  other.seconds - one.seconds < kBeforeGoal;
         });
}

struct Weighed {
  const Happening* happening;
  double weight;
};

// Heaviest first; of equals the earlier.
std::vector<Weighed> weighed(const std::vector<Happening>& all) {
  std::array<int, 16> before{};
  std::vector<Weighed> list;
  for (const Happening& one : all) {
    const double weight = weightOf(one.kind);
    if (weight <= 0.0) continue;
    const int repeated = before[static_cast<std::size_t>(one.kind)]++;
    const double lead = leadsToGoal(one, all) ? kLeadsToGoal : 0.0;
    list.push_back({&one, weight + lead - kRepeated * std::min(repeated, 2)});
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const Weighed& a, const Weighed& b) { return a.weight > b.weight; });
  return list;
}

double awayFrom(const std::vector<Happening>& chosen, double seconds) {
  double nearest = 1e9;
  for (const Happening& one : chosen) nearest = std::min(nearest, std::fabs(one.seconds - seconds));
  return nearest;
}

bool hasFrame(const std::vector<Happening>& chosen, std::size_t frame) {
  return std::any_of(chosen.begin(), chosen.end(),
                     [&](const Happening& one) { return one.frame == frame; });
}

void addHeaviest(const std::vector<Weighed>& heaviestFirst, double apart, std::size_t count,
                 std::vector<Happening>& chosen) {
  for (const Weighed& one : heaviestFirst)
    if (chosen.size() < count && !hasFrame(chosen, one.happening->frame) &&
        awayFrom(chosen, one.happening->seconds) >= apart)
      chosen.push_back(*one.happening);
}

// The one of `count` even times that is farthest from all that are chosen.
bool addStill(const Happening& first, const Happening& last, std::size_t count,
              std::vector<Happening>& chosen) {
  Happening best;
  double farthest = -1.0;
  for (std::size_t k = 0; k < count; ++k) {
    const double share = count == 1 ? 0.0 : static_cast<double>(k) / static_cast<double>(count - 1);
    const auto way = static_cast<double>(last.frame - first.frame);
    const auto frame = first.frame + static_cast<std::size_t>(std::lround(share * way));
    const double seconds = first.seconds + share * (last.seconds - first.seconds);
    const double away = awayFrom(chosen, seconds);
    if (hasFrame(chosen, frame) || away <= farthest) continue;
    farthest = away;
    best = {HappeningKind::still, frame, seconds, ""};
    if (k == 0) best.words = first.words;
    if (k + 1 == count) best.words = last.words;
  }
  if (farthest >= 0.0) chosen.push_back(best);
  return farthest >= 0.0;
}

}  // namespace

std::vector<Happening> chooseHighlights(const std::vector<Happening>& all, std::size_t count) {
  std::vector<Happening> chosen;
  if (all.empty() || count == 0) return chosen;
  const double length = all.back().seconds - all.front().seconds;
  for (const double share : kApartShares)
    addHeaviest(weighed(all), std::max(kMinSeconds, share * length), count, chosen);
  while (chosen.size() < count && addStill(all.front(), all.back(), count, chosen)) {
  }
  std::sort(chosen.begin(), chosen.end(),
            [](const Happening& a, const Happening& b) { return a.frame < b.frame; });
  return chosen;
}

}  // namespace kelpie::match
