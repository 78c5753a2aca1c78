// SPDX-License-Identifier: Apache-2.0
#include "tools/match/Happenings.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "tools/match/EventWords.h"
#include "tools/match/TraceWords.h"

namespace kelpie::match {
namespace {

constexpr double kMissing = 2.0;       // s unseen until the ball is missed
constexpr std::size_t kGoalAhead = 9;  // frames
constexpr double kBetweenHolds = 1.0;  // s without the ball until it is another hold

// "to the left" for angles that a person would call so.
std::string sideOf(Angle heading) {
  const double degrees = heading.deg();
  if (std::fabs(degrees) < 5.0) return "straight ahead";
  return fmt::format("{:.0f}° to the {}", std::fabs(degrees), degrees > 0.0 ? "left" : "right");
}

std::string placeOf(const BallPercept& ball) {
  return fmt::format("{:.0f} cm away, {}", ball.distance, sideOf(ball.heading));
}

// "upennLeft" -> "upenn left"
std::string spoken(MotionKind kind) {
  std::string words;
  for (const char c : std::string(kMotionKindNames[static_cast<std::size_t>(kind)])) {
    const bool capital = c >= 'A' && c <= 'Z';
    if (capital) words += ' ';
    words += capital ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return words;
}

const char* sideOf(FallSide side) {
  switch (side) {
    case FallSide::front: return "on its belly";
    case FallSide::back: return "on its back";
    case FallSide::left: return "on its left side";
    default: return "on its right side";
  }
}

HappeningKind kindOf(sim::EventKind kind) {
  using sim::EventKind;
  for (const EventKind stops : {EventKind::out, EventKind::penalty, EventKind::half,
                                EventKind::stuck, EventKind::taken, EventKind::carried})
    if (kind == stops) return HappeningKind::call;
  return kind == EventKind::goal ? HappeningKind::goal : HappeningKind::notice;
}

std::string capital(std::string sentence) {
  if (!sentence.empty() && sentence[0] >= 'a' && sentence[0] <= 'z')
    sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
  return sentence;
}

}  // namespace

void Happenings::add(HappeningKind kind, const std::string& words) {
  found_.push_back({kind, frame_, now_, words});
}

void Happenings::takeBall(const Moment& moment) {
  const BallPercept& ball = moment.output.percepts.ball;
  if (!ball.present) {
    if (!seen_ || missing_ || held_ || now_ - lastSeen_ < kMissing) return;
    missing_ = true;
    return add(HappeningKind::lost, "It has lost sight of the ball.");
  }
  if (!seen_) add(HappeningKind::sight, "First sight of the ball: " + placeOf(ball) + ".");
  if (missing_)
    add(HappeningKind::found, fmt::format("After {:.0f} s it finds the ball again: {}.",
                                          now_ - lastSeen_, placeOf(ball)));
  seen_ = true;
  missing_ = false;
  lastSeen_ = now_;
}

void Happenings::takeBody(const Moment& moment) {
  const MotionStatus& status = moment.input.motion;
  held_ = status.feeling.ballHeld;
  if (held_ && now_ - lastHeld_ > kBetweenHolds)
    add(HappeningKind::hold, "It has grabbed the ball and feels it under its chin.");
  if (held_) lastHeld_ = now_;
  if (status.running != running_ && isKick(status.running))
    add(HappeningKind::kick, fmt::format("It kicks the ball: {}.", spoken(status.running)));
  running_ = status.running;
  const bool fallen = status.feeling.fallen != FallSide::none;
  if (fallen && !fallen_)
    add(HappeningKind::fall,
        fmt::format("It has fallen and lies {}.", sideOf(status.feeling.fallen)));
  fallen_ = fallen;
}

// A goal is shown shortly before it falls: when it has fallen the robot waits already.
void Happenings::takeEvent(const sim::MatchEvent& event) {
  if (event.kind == sim::EventKind::start || event.kind == sim::EventKind::end) return;
  add(kindOf(event.kind), capital(sentenceOf(event)));
  if (event.kind != sim::EventKind::goal) return;
  Happening& goal = found_.back();
  goal.frame -= std::min(goal.frame, kGoalAhead);
}

void Happenings::take(const Moment& moment) {
  now_ = moment.input.time.seconds();
  if (frame_ == 0) add(HappeningKind::begin, "The first picture.");
  takeBody(moment);
  takeBall(moment);
  while (next_ < events_.size() && events_[next_].time <= moment.input.time)
    takeEvent(events_[next_++]);
  ++frame_;
}

std::vector<Happening> Happenings::all() {
  if (frame_ == 0) return {};
  --frame_;
  while (next_ < events_.size()) takeEvent(events_[next_++]);
  std::vector<Happening> all = found_;
  all.push_back({HappeningKind::end, frame_++, now_, "The last picture."});
  return all;
}

}  // namespace kelpie::match
