// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/referee/ControlledMatch.h"

#include <algorithm>
#include <utility>

#include "tools/sim/rules/ThrowIn.h"

namespace kelpie::sim {
namespace {

constexpr double kBallStays = 1.0;    // cm that the ball may move before the whistle
constexpr double kStray = 30.0;       // cm from where a robot waits
constexpr double kGone = 5.0;         // s without a packet: nobody is there any more
constexpr double kLateReport = 10.0;  // s after a ball was put back: its out may come so late

const char* wordsFor(net::ControlPenalty penalty) {
  constexpr std::array<const char*, 11> kWords = {"",
                                                  "ball holding",
                                                  "goalie pushing",
                                                  "player pushing",
                                                  "illegal defender",
                                                  "illegal defence",
                                                  "obstruction",
                                                  "request for pick-up",
                                                  "leaving the field",
                                                  "damage",
                                                  "a penalty of later years"};
  return kWords[static_cast<std::size_t>(penalty)];
}

const net::ControlTeam& teamOf(const net::GameControlData& control, TeamColour team) {
  return control.teams[control.teams[0].colour == team ? 0 : 1];
}

Point2<Field> middleOf(const body::FieldDescription& field) {
  return {0.5 * field.width, 0.5 * field.length};
}

}  // namespace

ControlledMatch::ControlledMatch(const body::FieldDescription& field) : field_(field) {
  control_.teams[0] = {0, TeamColour::blue, 0, {}};
  control_.teams[1] = {1, TeamColour::red, 0, {}};
}

void ControlledMatch::record(EventKind kind, TeamColour team, const char* reason) {
  MatchEvent event;
  event.time = scene_.time;
  event.kind = kind;
  event.team = team;
  event.ball = event.place = scene_.ball.position;
  event.reason.assign(reason);
  events_.push_back(event);
}

void ControlledMatch::record(EventKind kind, std::size_t player, const char* reason) {
  record(kind, scene_.players[player].team, reason);
  events_.back().player = scene_.players[player].number;
  events_.back().place = scene_.players[player].pose.position;
}

void ControlledMatch::putBall(Point2<Field> place) {
  scene_.ball = {place, {}};
  verdict_.ball = scene_.ball;
  touch_.velocity = {};
}

Verdict ControlledMatch::step(const MatchScene& scene, Score& score) {
  scene_ = scene;
  verdict_ = {};
  if (!started_) record(EventKind::start, control_.kickOff, "a game controller rules");
  started_ = true;
  if (finished_) return verdict_;
  for (std::size_t i = 0; i < scene_.players.size(); ++i) scene_.players[i].playing = !offField_[i];
  const bool heard = news_.has_value();
  if (heard) follow(score);
  if (control_.state == PlayState::playing) watchBall(score);
  if (control_.state == PlayState::set &&
      distance(scene_.ball.position, middleOf(field_)) > kBallStays)
    putBall(middleOf(field_));
  keepOffField();
  judgeEnd(heard);
  return verdict_;
}

void ControlledMatch::follow(Score& score) {
  const net::GameControlData before = std::exchange(control_, *news_);
  news_.reset();
  heard_ = scene_.time;
  for (const net::ControlTeam& team : control_.teams)
    followScore(team.colour, static_cast<int>(team.score), score);
  followPenalties();
  followDropIn(before);
  followState(before);
}

// A goal that is taken back is the team's last.
void ControlledMatch::followScore(TeamColour team, int scored, Score& score) {
  int& counted = team == TeamColour::red ? score.red : score.blue;
  for (; counted < scored; ++counted) {
    score.goals.push_back({team, scene_.time.seconds()});
    record(EventKind::goal, team, "");
  }
  for (; counted > scored; --counted) {
    const auto last = std::find_if(score.goals.rbegin(), score.goals.rend(),
                                   [team](const Goal& goal) { return goal.team == team; });
    if (last != score.goals.rend()) score.goals.erase(std::next(last).base());
  }
}

void ControlledMatch::followPenalties() {
  for (std::size_t i = 0; i < scene_.players.size(); ++i) {
    ScenePlayer& who = scene_.players[i];
    const auto& players = teamOf(control_, who.team).players;
    if (who.number < 1 || who.number > players.size()) continue;
    const net::ControlPenalty penalty = players[who.number - 1U].penalty;
    const bool off = penalty != net::ControlPenalty::none;
    if (off == offField_[i]) continue;
    offField_[i] = off;
    record(off ? EventKind::penalty : EventKind::back, i, wordsFor(penalty));
    carry(i, off ? waitingPlace(field_, who) : returnPlace(field_, scene_, i));
    who.playing = !off;
  }
}

// The world has put a ball back that went out before anybody can have reported it.
void ControlledMatch::followDropIn(const net::GameControlData& before) {
  const bool anew = control_.dropInSeconds < before.dropInSeconds;
  const bool done = putBack_ && (scene_.time - *putBack_).seconds() < kLateReport;
  if (!anew || done || inGoal_ || control_.state != PlayState::playing) return;
  record(EventKind::stuck, control_.dropInTeam, "the controller tells of a drop-in");
  putBall(dropIn(field_, scene_));
  events_.back().place = scene_.ball.position;
}

void ControlledMatch::followState(const net::GameControlData& before) {
  const bool sameHalf = before.firstHalf == control_.firstHalf;
  if (before.state == control_.state && sameHalf) return;
  touch_ = {};
  inGoal_ = false;
  putBack_.reset();
  const bool play = control_.state == PlayState::playing;
  const bool over = control_.state == PlayState::finished;
  if (!play && !over) putBall(middleOf(field_));
  switch (control_.state) {
    case PlayState::initial: return record(EventKind::start, control_.kickOff, "initial");
    case PlayState::ready: return record(EventKind::ready, control_.kickOff, "");
    case PlayState::set: return takePlaces();
    case PlayState::playing: return record(EventKind::play, control_.kickOff, "");
    case PlayState::finished: break;
  }
  record(control_.firstHalf ? EventKind::half : EventKind::end, control_.kickOff, "");
}

void ControlledMatch::takePlaces() {
  record(EventKind::set, control_.kickOff, "");
  for (std::size_t i = 0; i < scene_.players.size(); ++i) {
    ScenePlayer& player = scene_.players[i];
    if (!player.playing || standsLegally(field_, player, control_.kickOff)) continue;
    record(EventKind::placed, i, "not where it may stand");
    player.pose = manualPlace(field_, scene_, i, control_.kickOff);
    carry(i, player.pose);
  }
}

void ControlledMatch::watchBall(Score& score) {
  scene_.lastToucher = sim::step(scene_, field_, touch_);
  const auto team = goalFor(field_, scene_.ball.position);
  if (team && !inGoal_) {
    record(EventKind::out, *team, kInGoal);
    putBall(scene_.ball.position);
  }
  inGoal_ = team.has_value();
  if (team || !ballOut(field_, scene_.ball.position)) return;
  const auto by = scene_.lastToucher;
  record(EventKind::out, by ? scene_.players[*by].team : TeamColour::red,
         outOver(field_, scene_.ball.position));
  if (by) events_.back().player = scene_.players[*by].number;
  putBall(throwIn(field_, scene_));
  events_.back().place = scene_.ball.position;
  putBack_ = scene_.time;
  ++score.outs;
}

void ControlledMatch::keepOffField() {
  for (std::size_t i = 0; i < scene_.players.size(); ++i) {
    const Pose2 waits = waitingPlace(field_, scene_.players[i]);
    const bool carried = std::any_of(verdict_.carries.begin(), verdict_.carries.end(),
                                     [i](const Carry& one) { return one.robot == i; });
    if (!offField_[i] || carried) continue;
    if (distance(scene_.players[i].pose.position, waits.position) > kStray) carry(i, waits);
  }
}

void ControlledMatch::judgeEnd(bool heard) {
  if (control_.state != PlayState::finished) return;
  const bool gone = !heard && (scene_.time - heard_).seconds() >= kGone;
  if (control_.firstHalf && !gone) return;
  finished_ = true;
  if (control_.firstHalf) record(EventKind::end, control_.kickOff, "the controller is gone");
}

std::vector<MatchEvent> ControlledMatch::takeEvents() { return std::exchange(events_, {}); }

}  // namespace kelpie::sim
