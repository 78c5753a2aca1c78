// SPDX-License-Identifier: Apache-2.0
// How fast a match goes by the clock on the wall, and whether it goes at all.
#pragma once

#include <chrono>
#include <functional>

#include "robot/core/Time.h"

namespace kelpie::sim {

class Pace {
 public:
  // Of the clock's speed; 0: as fast as it can.
  explicit Pace(double speed) : speed_(speed) {}

  void setSpeed(double speed);
  // Also in the middle of steps.
  void pause();
  void resume();
  // So many camera images, then it stands.
  void step(int images);
  bool paused() const { return paused_; }

  // Waits until the match may go on to `now`. Meanwhile `hear` is called again and again, once at
  // least; `stopped` ends the wait.
  void await(TimeUs now, const std::function<void()>& hear, const std::function<bool()>& stopped);

 private:
  using Clock = std::chrono::steady_clock;
  bool mayPass(TimeUs now);
  Clock::duration leftUntil(TimeUs now);
  Clock::duration untilDue(TimeUs now);

  double speed_;
  bool paused_ = false;
  int images_ = 0;  // that may still pass while it stands
  bool begun_ = false;
  Clock::time_point since_;  // the match's time was
  TimeUs from_;              // this one
};

}  // namespace kelpie::sim
