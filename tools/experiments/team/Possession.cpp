// SPDX-License-Identifier: Apache-2.0
// What a team (--a) makes of the ball against another (--b), in matches in which they change
// colours: how its grabs end, how far its aimed kicks go beside the gap that they were aimed at,
// and how much nearer to the goal the ball is after each possession. Grabs are those of one
// forward, whose own reasons say how they ended; the ball's way is the true one.
#include <array>
#include <cmath>

#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/team/ExchangedSides.h"

namespace kelpie::experiments {
namespace {

constexpr double kHas = 40.0;     // cm from the neck base to a ball that a robot has,
constexpr double kHasFor = 0.3;   // s, until it is a possession
constexpr double kRolls = 0.4;    // s after a kick's end, until when the ball's way is taken:
constexpr double kRolled = 40.0;  // cm from where it lay. Farther on it may hit somebody, and one
                                  // that comes less far has, so that its way tells of no aim
constexpr double kPut = 20.0;     // cm in one image: faster than any ball, by hand

struct Found {
  int grabs = 0, chosen = 0, forced = 0, letGo = 0;  // the rest lost the ball
  Values headingErrors;                              // deg
  Values gains;                                      // cm up-field, of each possession
};

bool begins(const TraceStep& step, std::string_view start) {
  return step.reason.view().substr(0, start.size()) == start;
}

const TraceStep* stepOf(const PlayedMoment& moment, std::string_view module) {
  for (const TraceStep& step : moment.command.trace)
    if (step.module.view() == module) return &step;
  return nullptr;
}

// What is done with a ball that was grabbed; empty while none is.
std::string_view withBall(const PlayedMoment& moment) {
  const TraceStep* step = stepOf(moment, "grab_dribble");
  if (step == nullptr) return {};
  const std::string_view branch = step->branch.view();
  return branch == "grab" || branch == "ended" ? std::string_view{} : branch;
}

// The direction of the gap's middle over the field, as the robot looked at it; nothing without one.
std::optional<Angle> aimed(const PlayedMoment& moment) {
  const TraceStep* aim = stepOf(moment, "aim");
  const Pose2* pose = redPose(moment.truth, 2);
  if (aim == nullptr || pose == nullptr || aim->numbers.size() < 2) return std::nullopt;
  if (!begins(*aim, "gap")) return std::nullopt;
  return pose->heading + Angle::deg(0.5 * (aim->numbers[0] + aim->numbers[1]));
}

std::size_t later(const Played& played, std::size_t from, double seconds) {
  std::size_t i = from;
  while (i + 1 < played.moments.size() &&
         played.moments[i].seconds() - played.moments[from].seconds() < seconds)
    ++i;
  return i;
}

void judgeHeading(const Played& played, std::size_t kick, std::size_t end, Angle wanted,
                  Found& found) {
  const Point2<Field> from = played.moments[kick].truth.ball;
  const std::size_t last = later(played, end, kRolls);
  std::size_t at = kick;
  while (at < last && distance(from, played.moments[at].truth.ball) < kRolled) ++at;
  const Point2<Field> to = played.moments[at].truth.ball;
  if (distance(from, to) < kRolled) return;
  const Angle went = Angle::rad(std::atan2(to.y - from.y, to.x - from.x));
  found.headingErrors.push_back((went - wanted).abs().deg());
}

// The grabs of the watched robot.
void judgeGrabs(const Played& played, Found& found) {
  std::string_view before;
  std::size_t kick = 0;
  std::optional<Angle> gap, atKick;
  bool forced = false;
  for (std::size_t i = 0; i < played.moments.size(); ++i) {
    const PlayedMoment& moment = played.moments[i];
    if (!moment.seen) continue;
    const std::string_view now = withBall(moment);
    if (now.empty() && before == "kick" && atKick) judgeHeading(played, kick, i, *atKick, found);
    if (!now.empty() && before.empty()) ++found.grabs;
    if (const auto seen = aimed(moment)) gap = seen;
    if (now == "kick" && before != "kick") {
      forced = begins(*stepOf(moment, "grab_dribble"), "out of time");
      ++(forced ? found.forced : found.chosen);
      kick = i;
      atKick = forced ? std::nullopt : gap;
    }
    if (now == "release" && before != "release") ++found.letGo;
    if (now.empty()) gap.reset();
    before = now;
  }
}

// How far up-field the ball is at the end of each possession from where it was won.
void judgeGains(const Played& played, std::array<Values, 2>& gains) {
  const std::vector<bool> plays = inPlay(played);
  std::optional<TeamColour> has, near;
  double since = 0.0;
  Point2<Field> won, last;
  const auto end = [&] {
    if (!has) return;
    const bool red = *has == TeamColour::red;
    gains[red ? 0 : 1].push_back(red ? last.y - won.y : won.y - last.y);
    has.reset();
  };
  for (std::size_t i = 0; i < played.moments.size(); ++i) {
    const sim::TruthFrame& truth = played.moments[i].truth;
    if (!plays[i] || distance(last, truth.ball) > kPut) {
      end();
      near.reset();
    }
    last = truth.ball;
    if (!plays[i]) continue;
    const sim::RobotTruth& one = nearestToBall(truth);
    if (distance(one.pose.position, truth.ball) > kHas) continue;
    if (near != one.team) {
      near = one.team;
      since = truth.time.seconds();
    }
    if (has == near || truth.time.seconds() - since < kHasFor) continue;
    end();
    has = near;
    won = truth.ball;
  }
  end();
}

Expected<Json> possessions(const Request& request) {
  Found found;
  Values theirs;
  const Status done = playExchanged(request, "thesis", [&](bool aIsRed, const Played& played) {
    if (aIsRed) judgeGrabs(played, found);
    std::array<Values, 2> gains;
    judgeGains(played, gains);
    const Values& a = gains[aIsRed ? 0 : 1];
    const Values& b = gains[aIsRed ? 1 : 0];
    found.gains.insert(found.gains.end(), a.begin(), a.end());
    theirs.insert(theirs.end(), b.begin(), b.end());
  });
  if (!done) return Error{done.error()};
  const int lost = found.grabs - found.chosen - found.forced - found.letGo;
  return Json{{"grabs", found.grabs},
              {"chosen_share", ratio(found.chosen, found.grabs)},
              {"forced_share", ratio(found.forced + found.letGo, found.grabs)},
              {"lost_share", ratio(lost, found.grabs)},
              {"heading_error_median_deg", percentile(found.headingErrors, 0.5)},
              {"possessions", static_cast<int>(found.gains.size())},
              {"gain_mean_cm", mean(found.gains)},
              {"opponents_gain_mean_cm", mean(theirs)}};
}

const Registration kPossessions(
    "possession", "how the grabs of --a end, where its kicks go, what its possessions gain",
    {Option::trials, Option::seed, Option::fast, Option::minutes, Option::side, Option::opponents},
    2, possessions);

}  // namespace
}  // namespace kelpie::experiments
