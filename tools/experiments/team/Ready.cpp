// SPDX-License-Identifier: Apache-2.0
// Both teams stand in the other's half, anywhere and any way round, and walk home across each other
// in the ready state (checklist A-4.3.3.2): whether all are at their places when it ends. The
// referee puts nobody by hand who is there.
#include <set>

#include "robot/core/Random.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/team/TeamMatch.h"

namespace kelpie::experiments {
namespace {

constexpr double kSeconds = 2.0;   // of play: the ready state comes first
constexpr double kApart = 65.0;    // cm between two starts, more than two bodies in line
constexpr double kMargin = 30.0;   // cm from the lines
constexpr double kAtPlace = 30.0;  // cm

struct Found {
  Share all, robots;
  Values seconds, off;  // until set, and cm from the place then
};

Point2<Field> draw(const body::FieldDescription& field, TeamColour team, Random& random) {
  const double low = team == TeamColour::red ? 0.5 * field.length : 0.0;
  return {random.uniform(kMargin, field.width - kMargin),
          low + random.uniform(kMargin, 0.5 * field.length - kMargin)};
}

bool free(Point2<Field> p, const std::vector<sim::RobotPlace>& places) {
  for (const sim::RobotPlace& other : places)
    if (distance(p, other.pose.position) < kApart) return false;
  return true;
}

sim::Staging crossing(std::uint64_t seed) {
  const body::FieldDescription field;
  Random random(seed ^ 0x4ead1ULL);
  sim::Staging staging;
  std::vector<sim::RobotPlace>& places = staging.places;
  for (const TeamColour team : {TeamColour::red, TeamColour::blue})
    for (std::uint8_t player = 1; player <= 4; ++player) {
      Point2<Field> p = draw(field, team, random);
      while (!free(p, places)) p = draw(field, team, random);
      places.push_back({{team, player}, {p, Angle::rad(random.uniform(-maths::kPi, maths::kPi))}});
    }
  return staging;
}

void judge(const TeamMatch& match, Found& found) {
  static const body::FieldDescription field;
  double set = 0.0;
  for (const sim::MatchEvent& event : match.events)
    if (event.kind == sim::EventKind::set && set == 0.0) set = event.time.seconds();
  const sim::TruthFrame& truth = match.at(set - 0.1);
  bool all = true;
  for (const TeamRobot& robot : match.robots) {
    const TeamFrame* last = nullptr;
    for (const TeamFrame& frame : robot.frames)
      if (frame.state == PlayState::ready && frame.seconds < set && frame.note.wants) last = &frame;
    for (const sim::RobotTruth& one : truth.robots) {
      if (!robot.is(one)) continue;
      const Point2<Field> p = sim::ownView(field, robot.team, one.pose.position);
      const double off = last != nullptr ? distance(p, last->note.wanted) : 1000.0;
      found.off.push_back(off);
      found.robots.count(off < kAtPlace);
      all = all && off < kAtPlace;
    }
  }
  found.seconds.push_back(set);
  found.all.count(all);
}

Expected<Json> ready(const Request& request) {
  Found found;
  const auto each = [&](const cli::SessionResult&, const TeamMatch& match) { judge(match, found); };
  const Status played = playFours(request, {kSeconds, Kept::robots, crossing}, each);
  if (!played) return Error{played.error()};
  return Json{{"all_at_place_share", found.all.value()},
              {"robots_at_place_share", found.robots.value()},
              {"median_s", percentile(found.seconds, 0.5)},
              {"off_place_median_cm", percentile(found.off, 0.5)},
              {"off_place_p95_cm", percentile(found.off, 0.95)}};
}

const Registration kReady("ready", "two teams cross each other on the way to their places",
                          {Option::trials, Option::seed, Option::randomised, Option::params,
                           Option::fast},
                          40, ready);

}  // namespace
}  // namespace kelpie::experiments
