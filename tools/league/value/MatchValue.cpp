// SPDX-License-Identifier: Apache-2.0
#include "tools/league/value/MatchValue.h"

#include <algorithm>
#include <cmath>

#include "tools/sim/rules/MatchScene.h"
#include "tools/sim/world/Ball.h"

namespace kelpie::value {
namespace {

constexpr std::size_t kEvery = 3;       // frames between two moments that are looked at: 0.1 s
constexpr double kMinute = 60.0;        // s of play
constexpr double kKickSpeed = 60.0;     // cm/s, which walking into a ball does not give
constexpr double kAtBall = 25.0;        // cm from the neck base to a ball that a robot works at
constexpr double kReach = 40.0;         // cm from the neck base to a ball that is kicked
constexpr std::size_t kBlowFrames = 9;  // one blow and not each of its bounces
constexpr std::size_t kBefore = 6;      // frames before the blow, when the ball still lay
constexpr std::size_t kAfter = 3;       // frames after it, when the ball has its speed
constexpr double kShotBeside = 1.0;     // widths of the goal from its middle

std::size_t indexOf(TeamColour team) { return static_cast<std::size_t>(team); }

class Judge {
 public:
  Judge(const PlayedTruth& match, const Models& models, const body::FieldDescription& field)
      : match_(match), models_(models), field_(field) {}

  void take(const Stretch& stretch) {
    const FrameRange range = framesOf(match_, stretch);
    if (range.first >= range.last) return;
    for (std::size_t i = range.first; i < range.last; i += kEvery) addMoment(i, stretch, range);
    addDoings(range, stretch);
    findKicks(range);
    if (stretch.goal) {
      TeamFigures& scorer = figures_.teams[indexOf(*stretch.goal)];
      ++scorer.goals;
      ++minuteOf(scorer).goals;
    }
  }

  MatchFigures figures() { return std::move(figures_); }

 private:
  double secondsAt(std::size_t frame) const { return match_.frames[frame].time.seconds(); }

  TeamValues at(std::size_t frame) const {
    return valuesOf(models_.near, match_.frames[frame], field_);
  }

  TeamMinute& minuteOf(TeamFigures& team) const {
    const auto minute = static_cast<std::size_t>(figures_.played / kMinute);
    if (team.minutes.size() <= minute) team.minutes.resize(minute + 1);
    return team.minutes[minute];
  }

  // A probability to score within the horizon, over the horizon, is goals a second.
  void addMoment(std::size_t i, const Stretch& stretch, const FrameRange& range) {
    const double next = i + kEvery < range.last ? secondsAt(i + kEvery) : stretch.end;
    const double lasts = next - secondsAt(i);
    const TeamValues values = valuesOf(models_.far, match_.frames[i], field_);
    for (std::size_t team = 0; team < values.size(); ++team) {
      const double goals = values[team] * lasts / models_.far.horizon;
      figures_.teams[team].value += goals;
      minuteOf(figures_.teams[team]).value += goals;
    }
    figures_.played += lasts;
  }

  void addDoings(const FrameRange& range, const Stretch& stretch) {
    std::optional<Doing> doer;
    TeamValues before = at(range.first);
    for (std::size_t i = range.first; i < range.last; i += kEvery) {
      if (const sim::RobotTruth* const robot = whoHasBall(match_.frames[i]); robot != nullptr)
        doer = Doing{secondsAt(i), robot->team, robot->player, 0.0, 0.0};
      const bool last = i + kEvery >= range.last;
      const TeamValues after = last ? atEnd(stretch, before) : at(i + kEvery);
      if (doer) {
        doer->lasts = (last ? stretch.end : secondsAt(i + kEvery)) - secondsAt(i);
        doer->gained = netOf(after, doer->team) - netOf(before, doer->team);
        figures_.doings.push_back(*doer);
      }
      before = after;
    }
  }

  static double netOf(const TeamValues& values, TeamColour team) {
    return values[indexOf(team)] - values[indexOf(sim::otherTeam(team))];
  }

  static TeamValues atEnd(const Stretch& stretch, const TeamValues& before) {
    if (!stretch.goal) return before;
    TeamValues end{};
    end[indexOf(*stretch.goal)] = 1.0;
    return end;
  }

  static const sim::RobotTruth* nearestOf(const sim::TruthFrame& truth, double reach) {
    const auto nearest = std::min_element(
        truth.robots.begin(), truth.robots.end(), [&](const auto& a, const auto& b) {
          return distance(a.pose.position, truth.ball) < distance(b.pose.position, truth.ball);
        });
    const bool there =
        nearest != truth.robots.end() && distance(nearest->pose.position, truth.ball) <= reach;
    return there ? nearest : nullptr;
  }
  static const sim::RobotTruth* whoHasBall(const sim::TruthFrame& truth) {
    return nearestOf(truth, kAtBall);
  }

  void findKicks(const FrameRange& range) {
    for (std::size_t i = range.first + 1; i + kAfter < range.last; ++i) {
      const sim::TruthFrame& truth = match_.frames[i];
      const bool begins = truth.ballVelocity.norm() >= kKickSpeed &&
                          match_.frames[i - 1].ballVelocity.norm() < kKickSpeed;
      if (!begins || !addKick(i, range)) continue;
      i += kBlowFrames;
    }
  }

  bool addKick(std::size_t i, const FrameRange& range) {
    const sim::TruthFrame& truth = match_.frames[i];
    const sim::RobotTruth* const kicker = nearestOf(truth, kReach);
    if (kicker == nullptr) return false;
    const TeamValues before = at(std::max(range.first, i - std::min(i, kBefore)));
    const TeamValues after = at(i + kAfter);
    const std::size_t own = indexOf(kicker->team);
    Kick kick{truth.time.seconds(),
              kicker->team,
              kicker->player,
              netOf(after, kicker->team) - netOf(before, kicker->team),
              isShot(stateOf(match_.frames[i + kAfter], kicker->team, field_)),
              0.0};
    if (kick.shot) kick.goals = after[own];
    figures_.kicks.push_back(kick);
    figures_.teams[own].shots += kick.shot ? 1 : 0;
    figures_.teams[own].shotGoals += kick.goals;
    return true;
  }

  bool isShot(const TeamState& state) const {
    constexpr double kLongest = 60.0;  // s; every ball lies by then
    sim::Ball ball{state.ball, state.velocity};
    sim::roll(ball, kLongest, sim::BallParams{});
    if (ball.position.y < field_.length || state.ball.y >= field_.length) return false;
    const double share = (field_.length - state.ball.y) / (ball.position.y - state.ball.y);
    const double x = state.ball.x + share * (ball.position.x - state.ball.x);
    return std::fabs(x - 0.5 * field_.width) <= kShotBeside * field_.goalWidth;
  }

  const PlayedTruth& match_;
  const Models& models_;
  const body::FieldDescription& field_;
  MatchFigures figures_;
};

}  // namespace

MatchFigures figuresOf(const PlayedTruth& match, const Models& models,
                       const body::FieldDescription& field) {
  Judge judge(match, models, field);
  for (const Stretch& stretch : stretchesOf(match)) judge.take(stretch);
  return judge.figures();
}

Expected<MatchFigures> figuresOfLog(const std::string& path, const Models& models,
                                    const body::FieldDescription& field) {
  const auto match = readTruth(path);
  if (!match) return Error{match.error()};
  return figuresOf(*match, models, field);
}

double sceneValue(const MatchFigures& figures, double horizon, double seconds) {
  const int goals = figures.of(TeamColour::red).goals - figures.of(TeamColour::blue).goals;
  return figures.value() + goals * std::max(0.0, seconds - figures.played) / horizon;
}

}  // namespace kelpie::value
