// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/rules/RuledMatch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/sim/rules/ThrowIn.h"

namespace kelpie::sim {
namespace {

constexpr double kBallStays = 1.0;  // cm that the ball may move before the whistle

std::size_t numberOf(TeamColour team) { return team == TeamColour::red ? 0 : 1; }
std::uint8_t clipped(int score) { return static_cast<std::uint8_t>(std::clamp(score, 0, 255)); }

// Whether it was a goalie that was pushed is not distinguished.
net::ControlPenalty controlPenalty(Offence offence) {
  switch (offence) {
    case Offence::ownBox: return net::ControlPenalty::illegalDefender;
    case Offence::leftField: return net::ControlPenalty::leavingTheField;
    case Offence::fallen: return net::ControlPenalty::damage;
    case Offence::heldTooLong:
    case Offence::carriedTooFar: return net::ControlPenalty::ballHolding;
    case Offence::pushing: break;
  }
  return net::ControlPenalty::playerPushing;
}

}  // namespace

RuledMatch::RuledMatch(const body::FieldDescription& field, const ClockState& clock)
    : field_(field), clock_(clock) {}

void RuledMatch::record(Call call, TeamColour team) {
  MatchEvent event;
  event.time = scene_.time;
  event.kind = call.kind;
  event.team = team;
  event.ball = scene_.ball.position;
  event.place = event.ball;
  event.reason.assign(call.reason);
  events_.push_back(event);
}

void RuledMatch::record(Call call, std::size_t player) {
  const ScenePlayer& who = scene_.players[player];
  record(call, who.team);
  events_.back().player = who.number;
  events_.back().place = who.pose.position;
}

void RuledMatch::putBall(Point2<Field> place) {
  scene_.ball = {place, {}};
  verdict_.ball = scene_.ball;
  touch_.velocity = {};
  touch_.scorer.reset();
  stuck_.since.reset();
}

void RuledMatch::carry(std::size_t player, const Pose2& place) {
  scene_.players[player].pose = place;
  auto& carries = verdict_.carries;
  const auto same = std::find_if(carries.begin(), carries.end(),
                                 [player](const Carry& one) { return one.robot == player; });
  if (same == carries.end())
    carries.push_back({player, place});
  else
    same->place = place;
}

Verdict RuledMatch::step(const MatchScene& scene, Score& score) {
  scene_ = scene;
  verdict_ = {};
  goal_.reset();
  for (std::size_t i = 0; i < scene_.players.size(); ++i)
    scene_.players[i].playing = !penalties_.of[i].off;
  if (!started_) {
    record({EventKind::start}, clock_.kickOff);
    if (clock_.state == PlayState::initial) putBall({0.5 * field_.width, 0.5 * field_.length});
  }
  started_ = true;
  if (finished()) return verdict_;
  if (scene.ballAway) goOn();
  if (clock_.state == PlayState::playing && !scene.ballAway) judgePlay(score);
  judgePenalties();
  runClock();
  return verdict_;
}

void RuledMatch::judgePlay(Score& score) {
  scene_.lastToucher = sim::step(scene_, field_, touch_);
  if (const auto team = goalFor(field_, scene_.ball.position)) return judgeGoal(*team, score);
  if (ballOut(field_, scene_.ball.position)) {
    const auto by = scene_.lastToucher;
    dropInTeam_ = by ? scene_.players[*by].team : dropInTeam_;
    droppedIn_ = scene_.time;
    record({EventKind::out, outOver(field_, scene_.ball.position)}, dropInTeam_);
    if (by) events_.back().player = scene_.players[*by].number;
    putBall(throwIn(field_, scene_));
    events_.back().place = scene_.ball.position;
    ++score.outs;
  }
  judgeFouls(sim::step(scene_, field_, fouls_), score);
  judgeFouls(sim::step(scene_, field_.rules, holding_), score);
  judgeFouls(sim::step(scene_, field_, pushing_), score);
  if (!sim::step(scene_, field_.rules, stuck_)) return;
  ++score.stuck;
  record({EventKind::stuck, "the ball goes nowhere"}, TeamColour::red);
  putBall(dropIn(field_, scene_));
  events_.back().place = scene_.ball.position;
}

void RuledMatch::judgeGoal(TeamColour team, Score& score) {
  goal_ = team;
  ++(team == TeamColour::red ? score.red : score.blue);
  Goal goal{team, scene_.time.seconds()};
  // Who plays a shot that it saved into the other goal has scored.
  const bool lasts = touch_.last && scene_.players[*touch_.last].team == team;
  if (const auto scorer = lasts ? touch_.last : touch_.scorer) {
    const ScenePlayer& by = scene_.players[*scorer];
    goal.own = by.team != team;
    goal.player = by.number;
  }
  score.goals.push_back(goal);
  record({EventKind::goal, goal.own ? "own goal" : ""}, team);
  events_.back().player = goal.player;
}

void RuledMatch::judgeFouls(const Fouls& fouls, Score& score) {
  for (const Foul& foul : fouls) {
    ScenePlayer& who = scene_.players[foul.player];
    who.playing = false;  // and commits no other foul in this step
    const auto left = TimeUs::fromSeconds(field_.rules.penaltyTime);
    penalties_.of[foul.player] = {true, scene_.time + left, foul.offence};
    ++score.penalties[numberOf(who.team)][static_cast<std::size_t>(foul.offence)];
    record({EventKind::penalty, wordsFor(foul.offence)}, foul.player);
    carry(foul.player, waitingPlace(field_, who));
  }
}

void RuledMatch::judgePenalties() {
  const PenaltyOut out = sim::step(scene_, clock_.state, field_, penalties_);
  for (const std::size_t player : out.stray)
    carry(player, waitingPlace(field_, scene_.players[player]));
  for (const std::size_t player : out.back) {
    carry(player, returnPlace(field_, scene_, player));
    scene_.players[player].playing = true;
    record({EventKind::back}, player);
  }
}

void RuledMatch::runClock() {
  ClockIn in{scene_.time, false, goal_};
  if (clock_.state == PlayState::ready)
    in.placesTaken = sim::step({scene_, clock_.kickOff}, field_, kickOff_);
  const Point2<Field> middle{0.5 * field_.width, 0.5 * field_.length};
  if (clock_.state == PlayState::set && distance(scene_.ball.position, middle) > kBallStays)
    putBall(middle);
  const auto began = sim::step(in, field_.rules, clock_);
  if (!began) return;
  record({*began}, clock_.kickOff);
  if (*began == EventKind::set) takePlaces();
  if (*began == EventKind::play) goOn();
  if (*began == EventKind::end) return;
  // Who takes the ball out of a goal or an arm puts it where the next kick-off is.
  if (*began != EventKind::play) putBall(middle);
  kickOff_ = {};
}

void RuledMatch::takePlaces() {
  for (std::size_t i = 0; i < scene_.players.size(); ++i) {
    const ScenePlayer& player = scene_.players[i];
    if (!player.playing || standsLegally(field_, player, clock_.kickOff)) continue;
    record({EventKind::placed, "not where it may stand"}, i);
    carry(i, manualPlace(field_, scene_, i, clock_.kickOff));
  }
}

// What was before the whistle, or while the ball was away, is no foul.
void RuledMatch::goOn() {
  touch_ = {};
  fouls_ = {};
  holding_ = {};
  pushing_ = {};
  stuck_ = {};
}

std::vector<MatchEvent> RuledMatch::takeEvents() { return std::exchange(events_, {}); }

GameState RuledMatch::gameFor(std::size_t player, const Score& score) const {
  const ScenePlayer& who = scene_.players[player];
  const bool red = who.team == TeamColour::red;
  GameState game;
  game.state = clock_.state;
  game.team = who.team;
  game.player = who.number;
  game.penalised = penalised(player);
  game.ownScore = clipped(red ? score.red : score.blue);
  game.opponentScore = clipped(red ? score.blue : score.red);
  const bool before = clock_.state == PlayState::ready || clock_.state == PlayState::set;
  game.kickOff = before && clock_.kickOff == who.team;
  game.firstHalf = clock_.firstHalf;
  game.secondsLeft = clock_.secondsLeft(field_.rules);
  return game;
}

net::GameControlData RuledMatch::control(const Score& score) const {
  const auto seconds = [](double s) {
    return static_cast<std::uint32_t>(std::ceil(std::max(0.0, s)));
  };
  net::GameControlData data;
  data.state = clock_.state;
  data.firstHalf = clock_.firstHalf;
  data.kickOff = clock_.kickOff;
  data.secondsLeft = seconds(finished() ? 0.0 : field_.rules.halfTime - clock_.played.seconds());
  data.dropInTeam = dropInTeam_;
  if (droppedIn_)
    data.dropInSeconds = static_cast<std::uint32_t>((scene_.time - *droppedIn_).seconds());
  for (const TeamColour team : {TeamColour::blue, TeamColour::red}) {
    net::ControlTeam& out = data.teams[team == TeamColour::blue ? 0 : 1];
    out.number = team == TeamColour::blue ? 0 : 1;
    out.colour = team;
    out.score = clipped(team == TeamColour::red ? score.red : score.blue);
    for (std::size_t i = 0; i < scene_.players.size(); ++i) {
      const ScenePlayer& who = scene_.players[i];
      if (who.team != team || !penalised(i) || who.number > net::kControlPlayers) continue;
      out.players[who.number - 1U] = {controlPenalty(penalties_.of[i].offence),
                                      seconds(penalties_.secondsLeft(i, scene_.time))};
    }
  }
  return data;
}

}  // namespace kelpie::sim
