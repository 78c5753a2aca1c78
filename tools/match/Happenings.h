// SPDX-License-Identifier: Apache-2.0
// What happened in a match to the robot whose log it is, taken from its moments one by one: first
// sight of the ball, holds, kicks, falls, and what the referee calls. Of what flickers only the
// first change is taken. Another robot's holds and kicks are not in this robot's log.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/match/Draw.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::match {

enum class HappeningKind : std::uint8_t {
  begin,  // the first frame
  sight,
  hold,
  kick,
  fall,
  lost,
  found,
  goal,
  call,    // of the referee that stops play, or a person's hand
  notice,  // of the referee that does not
  end,     // the last frame
  still    // nothing in particular: a picture at an even time
};

struct Happening {
  HappeningKind kind = HappeningKind::still;
  std::size_t frame = 0;  // counts the moments from 0
  double seconds = 0.0;
  std::string words;  // what happened, as a sentence
};

class Happenings {
 public:
  // `events`: of the whole match, in the order of time.
  explicit Happenings(std::vector<sim::MatchEvent> events) : events_(std::move(events)) {}
  void take(const Moment& moment);
  // All of them in the order of time, the end of the match included. What was called after the last
  // moment, as the goal that ends a match, is shown in that.
  std::vector<Happening> all();

 private:
  void add(HappeningKind kind, const std::string& words);
  void takeBall(const Moment& moment);
  void takeBody(const Moment& moment);
  void takeEvent(const sim::MatchEvent& event);

  std::vector<sim::MatchEvent> events_;
  std::size_t next_ = 0;  // of these
  std::vector<Happening> found_;
  std::size_t frame_ = 0;
  double now_ = 0.0;
  bool seen_ = false;  // the ball, at least once
  double lastSeen_ = 0.0;
  bool missing_ = false;
  bool held_ = false;
  double lastHeld_ = -100.0;
  MotionKind running_ = MotionKind::none;
  bool fallen_ = false;
};

}  // namespace kelpie::match
