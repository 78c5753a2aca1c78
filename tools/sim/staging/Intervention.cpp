// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/staging/Intervention.h"

#include <algorithm>
#include <utility>

namespace kelpie::sim {
namespace {

constexpr double kRobotsApart = 20.0;  // cm between the middles of two bodies
constexpr double kBallApart = 16.0;    // cm from the middle of a body

bool isThere(const MatchScene& scene, std::size_t robot, const Pose2& place) {
  for (std::size_t i = 0; i < scene.players.size(); ++i)
    if (i != robot && stripeDistance(place, scene.players[i].pose) < kRobotsApart) return true;
  return stripeDistance(place, scene.ball.position) < kBallApart;
}

}  // namespace

Intervention::Intervention(const Setup& setup, const body::FieldDescription& field)
    : takes_(setup.takes), middle_{0.5 * field.width, 0.5 * field.length} {
  for (const RobotCarry& one : setup.carries) carries_.push_back({one});
}

// Of several places at one moment, as of a match that stands, the last counts.
void Intervention::putBall(TimeUs now, Point2<Field> place) {
  const BallTake put{now.seconds(), 0.0, place};
  const auto next = takes_.begin() + static_cast<std::ptrdiff_t>(taken_);
  const bool again = next != takes_.end() && next->seconds == 0.0 && next->time == put.time;
  if (away_ || again)
    *next = put;
  else
    takes_.insert(next, put);
}

void Intervention::carry(const RobotCarry& order) {
  const auto same = [&](const Carrying& one) {
    return !one.done && one.order.robot.team == order.robot.team &&
           one.order.robot.player == order.robot.player && one.order.time <= order.time;
  };
  carries_.erase(std::remove_if(carries_.begin(), carries_.end(), same), carries_.end());
  carries_.push_back({order});
}

void Intervention::record(const MatchScene& scene, EventKind kind) {
  MatchEvent event;
  event.time = scene.time;
  event.kind = kind;
  event.ball = away_ ? takenFrom_ : scene.ball.position;
  event.place = event.ball;
  events_.push_back(event);
}

void Intervention::moveBall(const MatchScene& scene, Verdict& verdict) {
  const double now = scene.time.seconds();
  if (away_ && now >= takes_[taken_].time + takes_[taken_].seconds) {
    const Point2<Field> back = takes_[taken_++].back.value_or(middle_);
    away_ = false;
    verdict.ball = Ball{back, {}};
    record(scene, EventKind::returned);
    events_.back().ball = events_.back().place = back;
  }
  if (away_ || taken_ >= takes_.size() || now < takes_[taken_].time) return;
  record(scene, EventKind::taken);
  takenFrom_ = scene.ball.position;
  away_ = true;
  verdict.ball = Ball{kAwayBall, {}};
}

void Intervention::carryRobots(const MatchScene& scene, Verdict& verdict) {
  for (Carrying& one : carries_) {
    if (one.done || scene.time.seconds() < one.order.time) continue;
    const auto named = [&](const ScenePlayer& p) {
      return p.team == one.order.robot.team && p.number == one.order.robot.player;
    };
    const auto who = std::find_if(scene.players.begin(), scene.players.end(), named);
    const auto robot = static_cast<std::size_t>(who - scene.players.begin());
    if (who == scene.players.end() || isThere(scene, robot, one.order.pose)) continue;
    one.done = true;
    verdict.carries.push_back({robot, one.order.pose});
    record(scene, EventKind::carried);
    events_.back().team = who->team;
    events_.back().player = who->number;
    events_.back().place = one.order.pose.position;
    return;  // two at once would not see each other
  }
}

Verdict Intervention::step(const MatchScene& scene) {
  Verdict verdict;
  moveBall(scene, verdict);
  carryRobots(scene, verdict);
  return verdict;
}

std::vector<MatchEvent> Intervention::takeEvents() { return std::exchange(events_, {}); }

}  // namespace kelpie::sim
