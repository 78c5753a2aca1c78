// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/skills/Judges.h"

#include <cmath>

#include "tools/experiments/skills/Tries.h"

namespace kelpie::experiments {
namespace {

constexpr double kAfterHold = 0.6;     // s in which a shot comes of the hold before it
constexpr double kPast = 40.0;         // cm beyond the opponent's neck base, towards the goal
constexpr double kShotSeconds = 2.5;   // in which a shot has got past or has not
constexpr double kWatched = 2.5;       // s before a throw, in which the robot must have the ball
constexpr double kWatchedShare = 0.5;  // the head looks at landmarks too
constexpr double kKickReach = 40.0;    // cm from the neck base
constexpr double kSlow = 10.0;     // cm/s towards the goal: up to there nobody has set the ball off
constexpr double kKept = 0.4;      // s; a ball walked over, or lunged after, stays shorter
constexpr double kCarried = 10.0;  // cm
constexpr double kTurned = 0.35;   // rad, 20 deg
constexpr double kReach = 15.0;    // cm ahead of the neck base
constexpr double kReachLateral = 8.0;  // cm

const body::FieldDescription& playedField() {
  static const body::FieldDescription field;
  return field;
}

Point2<Field> goalMiddle() { return {playedField().width / 2.0, playedField().length}; }

bool comesOfAHold(const Shot& shot, const std::vector<sim::Hold>& holds) {
  for (const sim::Hold& hold : holds)
    if (shot.time >= hold.end - kAfterHold && shot.time <= hold.end + kAfterHold) return true;
  return false;
}

// How far the ball is beyond the opponent, towards the goal.
double beyond(const PlayedMoment& moment) {
  const Point2<Field> opponent = moment.robot(TeamColour::blue).position;
  const Point2<Field> way = goalMiddle() - opponent;
  const Point2<Field> ball = moment.truth.ball - opponent;
  return (ball.x * way.x + ball.y * way.y) / way.norm();
}

bool passesAfter(const Played& played, const Shot& shot) {
  for (std::size_t i = shot.moment; i < played.moments.size(); ++i) {
    const PlayedMoment& moment = played.moments[i];
    if (moment.seconds() > shot.time + kShotSeconds) break;
    if (beyond(moment) > kPast) return true;
  }
  return false;
}

bool outsideBox(const body::FieldDescription& field, Point2<Field> p) {
  return p.y < field.length - field.boxDepth ||
         std::fabs(p.x - field.width / 2.0) > field.boxWidth / 2.0;
}

// Whether the keeper itself set off the ball that went into its goal: when the ball last did not
// roll there, it was the nearer one and the attacker out of reach.
bool setOffByKeeper(const Played& played) {
  const auto& all = played.moments;
  for (std::size_t i = all.size(); i-- > 0;) {
    if (all[i].truth.ballVelocity.y > kSlow) continue;
    const auto far = [&](TeamColour team) {
      return distance(all[i].robot(team).position, all[i].truth.ball);
    };
    return far(TeamColour::blue) < far(TeamColour::red) && far(TeamColour::red) > kKickReach;
  }
  return false;
}

// How many frames each run of that motion took. The one that the end cuts off is no whole run.
Values runsOf(const Played& played, MotionKind kind) {
  Values runs;
  int frames = 0;
  for (const PlayedMoment& moment : played.moments) {
    if (!moment.seen) continue;
    const bool running = moment.motion.running == kind;
    if (!running && frames > 0) runs.push_back(frames);
    frames = running ? frames + 1 : 0;
  }
  return runs;
}

bool atBall(const PlayedMoment& moment) {
  const Point2<Robot> ball = robotFromField(moment.robot(TeamColour::red), moment.truth.ball);
  return ball.y > 0.0 && ball.y < kReach && std::fabs(ball.x) < kReachLateral;
}

}  // namespace

Aimed aimedIn(const Played& played) {
  const body::FieldDescription& field = playedField();
  const std::vector<sim::Hold> holds = holdsOf(played, TeamColour::red);
  Aimed aimed;
  for (const Shot& shot : shotsOf(played, TeamColour::red)) {
    if (!comesOfAHold(shot, holds)) continue;
    const auto across = crossing(shot, field.length);
    aimed.shot = true;
    aimed.errorDeg = (shot.direction - headingTo(shot.from, goalMiddle())).deg();
    aimed.onTarget = across && std::fabs(*across - goalMiddle().x) < field.goalWidth / 2.0;
    break;
  }
  return aimed;
}

Dodged dodgedIn(const Played& played, double limit) {
  Dodged dodged;
  const double end = played.outAfter(0.0).value_or(limit);
  for (const PlayedMoment& moment : played.moments)
    dodged.passed = dodged.passed || (moment.seconds() <= end && beyond(moment) > kPast);
  for (const Shot& shot : shotsOf(played, TeamColour::red))
    if (shot.time <= end && beyond(played.moments[shot.moment]) < -10.0)
      dodged.shots.count(passesAfter(played, shot));
  return dodged;
}

Searched searchedIn(const Played& played, double thrown, double limit) {
  Searched searched;
  searched.seconds = limit;
  Share before;
  bool last = false;
  for (const PlayedMoment& moment : played.moments) {
    const double since = moment.seconds() - thrown;
    const bool has =
        moment.seen && isBall(moment.ball, moment.robot(TeamColour::red), moment.truth.ball);
    if (since >= -kWatched && since < 0.0) before.count(has);
    // The first image of which all was exposed after the throw; two in a row are no accident.
    if (since >= 2.0 * kFrameSeconds && has && last) {
      searched.seconds = std::fmin(searched.seconds, since - kFrameSeconds);
      break;
    }
    last = has && since >= kFrameSeconds;
  }
  searched.watched = before.value() >= kWatchedShare;
  searched.lost = searched.seconds > 0.2;
  return searched;
}

Kept keptIn(const Played& played, bool scored) {
  Kept kept;
  kept.setOff = scored && setOffByKeeper(played);
  for (const PlayedMoment& moment : played.moments)
    kept.outside.count(outsideBox(playedField(), moment.robot(TeamColour::blue).position));
  return kept;
}

Grabbed grabbedIn(const Played& played) {
  const body::Rules rules;
  Grabbed grabbed;
  grabbed.grabs = runsOf(played, MotionKind::grab);
  grabbed.quickGrabs = runsOf(played, MotionKind::grabQuick);
  const double last = played.moments.empty() ? 0.0 : played.moments.back().seconds();
  for (const sim::Hold& hold : holdsOf(played, TeamColour::red)) {
    const bool kept = hold.seconds() >= kKept;
    if (kept) grabbed.holds.push_back(hold.seconds());
    grabbed.tooLong += hold.tooLong(rules) ? 1 : 0;
    grabbed.tooFar += hold.tooFar(rules) ? 1 : 0;
    const bool carried = hold.moved >= kCarried || hold.turned >= kTurned;
    const bool released = hold.end + sim::HoldWatch::kLost < last;
    grabbed.kept = grabbed.kept || kept;
    grabbed.success = grabbed.success ||
                      (kept && carried && released && !hold.tooLong(rules) && !hold.tooFar(rules));
  }
  return grabbed;
}

Met metIn(const Played& played, double thrown, double limit) {
  Met met;
  met.seconds = limit;
  const auto out = played.outAfter(thrown);
  met.kept = !out;
  for (const PlayedMoment& moment : played.moments) {
    if (moment.seconds() <= thrown + kFrameSeconds) continue;
    if (out && moment.seconds() >= *out) break;
    if (!atBall(moment)) continue;
    met.reached = true;
    met.seconds = moment.seconds() - thrown;
    break;
  }
  return met;
}

}  // namespace kelpie::experiments
