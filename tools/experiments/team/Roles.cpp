// SPDX-License-Identifier: Apache-2.0
// Coherent play (checklist ): whether exactly one forward of a team attacks, how often roles
// change, where each role is, and whether forwards keep out of their own box. Two teams of four
// play by the rules; only frames of robots that play count.
#include <array>
#include <cmath>
#include <map>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/team/TeamMatch.h"

namespace kelpie::experiments {
namespace {

constexpr double kSeconds = 600.0;
constexpr double kFramesASecond = 30.0;

// Forwards of one team in one frame.
struct Line {
  int playing = 0;
  int attackers = 0;
};

struct Found {
  Share oneAttacker, none, two, inOwnBox;
  int changes = 0;
  double seconds = 0.0;  // of forwards that play
  std::array<std::array<Share, 3>, kRoleCount> thirds;
};

bool inOwnBox(const body::FieldDescription& field, Point2<Field> p) {
  return p.y < field.boxDepth && std::fabs(p.x - field.width / 2.0) < field.boxWidth / 2.0;
}

void countThird(const body::FieldDescription& field, double y, Role role, Found& found) {
  const auto third = static_cast<std::size_t>(maths::clamp(3.0 * y / field.length, 0.0, 2.0));
  for (std::size_t i = 0; i < 3; ++i)
    found.thirds[static_cast<std::size_t>(role)][i].count(i == third);
}

// The camera's frames of all robots are exposed together; the middle of one is half a frame after
// its beginning.
int frameOf(double seconds) { return static_cast<int>(seconds * kFramesASecond); }

void judgeRobot(const TeamMatch& match, const TeamRobot& robot, std::map<int, Line>& lines,
                Found& found) {
  static const body::FieldDescription field;
  const TeamFrame* last = nullptr;
  for (const TeamFrame& frame : robot.frames) {
    const bool plays = frame.plays();
    if (plays) {
      Line& line = lines[frameOf(frame.seconds)];
      ++line.playing;
      line.attackers += frame.note.role == Role::attacker ? 1 : 0;
      found.seconds += 1.0 / kFramesASecond;
      found.changes += last != nullptr && last->note.role != frame.note.role ? 1 : 0;
      for (const sim::RobotTruth& truth : match.at(frame.seconds).robots) {
        if (!robot.is(truth)) continue;
        const Point2<Field> p = sim::ownView(field, robot.team, truth.pose.position);
        found.inOwnBox.count(inOwnBox(field, p));
        countThird(field, p.y, frame.note.role, found);
      }
    }
    last = plays ? &frame : nullptr;
  }
}

void judgeTeam(const TeamMatch& match, TeamColour team, Found& found) {
  std::map<int, Line> lines;
  for (const TeamRobot& robot : match.robots)
    if (robot.team == team && robot.player != 1) judgeRobot(match, robot, lines, found);
  for (const auto& [frame, line] : lines) {
    found.oneAttacker.count(line.attackers == 1);
    found.none.count(line.attackers == 0);
    found.two.count(line.attackers > 1);
  }
}

Json thirdsOf(const Found& found) {
  Json all = Json::object();
  for (std::size_t role = 0; role < kRoleCount; ++role) {
    const auto& thirds = found.thirds[role];
    if (thirds[0].all == 0) continue;
    all[kRoleNames[role]] = Json{thirds[0].value(), thirds[1].value(), thirds[2].value()};
  }
  return all;
}

Expected<Json> roles(const Request& request) {
  Found found;
  const auto judge = [&](const cli::SessionResult&, const TeamMatch& match) {
    judgeTeam(match, TeamColour::red, found);
    judgeTeam(match, TeamColour::blue, found);
  };
  const Status played = playFours(request, {kSeconds}, judge);
  if (!played) return Error{played.error()};
  return Json{{"one_attacker_share", found.oneAttacker.value()},
              {"no_attacker_share", found.none.value()},
              {"two_attackers_share", found.two.value()},
              {"role_changes_per_robot_minute", ratio(60.0 * found.changes, found.seconds)},
              {"forwards_in_own_box", found.inOwnBox.value()},
              {"share_in_own_middle_other_third", thirdsOf(found)}};
}

const Registration kRoles(
    "roles", "four against four for ten minutes: one attacker, role changes, boxes",
    {Option::trials, Option::seed, Option::randomised, Option::params, Option::fast}, 1, roles);

}  // namespace
}  // namespace kelpie::experiments
