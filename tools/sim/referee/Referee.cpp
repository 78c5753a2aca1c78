// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/referee/Referee.h"

#include <algorithm>
#include <utility>

namespace kelpie::sim {

Referee::Referee(const RefereeParams& params, const body::FieldDescription& field)
    : params_(params), field_(field) {
  if (params.controlled)
    controlled_.emplace(field);
  else if (params.rules)
    ruled_.emplace(field, params.fromPlay ? clockInPlay(params.kickOff) : clockFor(params.kickOff));
}

void Referee::hear(const net::GameControlData& control) {
  if (controlled_) controlled_->hear(control);
}

// Without rules the ball is in play from the first tick to the end.
net::GameControlData Referee::control() const {
  if (controlled_) return controlled_->control();
  if (ruled_) return ruled_->control(score_);
  const auto clipped = [](int score) { return static_cast<std::uint32_t>(std::min(255, score)); };
  net::GameControlData data;
  data.state = finished_ ? PlayState::finished : PlayState::playing;
  data.teams[0] = {0, TeamColour::blue, clipped(score_.blue), {}};
  data.teams[1] = {1, TeamColour::red, clipped(score_.red), {}};
  return data;
}

Verdict Referee::judge(const MatchScene& scene) {
  Verdict verdict;
  if (controlled_) {
    verdict = controlled_->step(scene, score_);
    finished_ = controlled_->finished() || scene.time.seconds() >= params_.seconds;
    return verdict;
  }
  if (ruled_) {
    verdict = ruled_->step(scene, score_);
    const int goals = std::max(score_.red, score_.blue);
    finished_ =
        ruled_->finished() || (params_.fromPlay && params_.goals > 0 && goals >= params_.goals);
    return verdict;
  }
  Ball ball = scene.ball;
  if (tick(scene.time, ball)) verdict.ball = ball;
  return verdict;
}

void Referee::record(TimeUs now, EventKind kind, TeamColour team, Point2<Field> ball) {
  MatchEvent event;
  event.time = now;
  event.kind = kind;
  event.team = team;
  event.ball = ball;
  events_.push_back(event);
}

bool Referee::tick(TimeUs now, Ball& ball) {
  if (!started_) record({0}, EventKind::start, TeamColour::red, ball.position);
  started_ = true;
  if (finished_) return false;
  const Ball was = ball;
  if (const auto team = goalFor(field_, ball.position)) {
    record(now, EventKind::goal, *team, ball.position);
    int& goals = *team == TeamColour::red ? score_.red : score_.blue;
    ++goals;
    score_.goals.push_back({*team, now.seconds()});
    finished_ = params_.goals > 0 && goals >= params_.goals;
    if (!finished_) ball = {{field_.width / 2.0, field_.length / 2.0}, {}};
  } else if (ballOut(field_, ball.position)) {
    record(now, EventKind::out, TeamColour::red, ball.position);
    ++score_.outs;
    ball = {body::throwInPlace(field_, ball.position), {}};
  }
  finished_ = finished_ || now.seconds() >= params_.seconds;
  if (finished_) record(now, EventKind::end, TeamColour::red, ball.position);
  return distance(was.position, ball.position) > 0.0;
}

std::vector<MatchEvent> Referee::takeEvents() {
  if (controlled_) return controlled_->takeEvents();
  return ruled_ ? ruled_->takeEvents() : std::exchange(events_, {});
}

}  // namespace kelpie::sim
