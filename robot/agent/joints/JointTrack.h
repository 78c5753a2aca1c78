// SPDX-License-Identifier: Apache-2.0
// The last 32 sensed ticks (256 ms), to tell where the joints were in the middle of an exposure,
// how fast the head turned and how the body stood. Images may lag by 130 ms and arrive 60 later.
// Beyond the newest tick the angles go on at the rate of the last four for at most 100 ms: half an
// exposure and a tick of delay, and 80 ms where joints are older than images. In 80 ms a head that
// turns back at 12 rad/s2 is 2 deg elsewhere; waiting for its joints would cost that much reaction
// in each frame.
#pragma once

#include <array>
#include <cstddef>

#include "robot/core/types/FrameInput.h"

namespace kelpie::agent {

class JointTrack {
 public:
  void add(TimeUs time, const SensorFrame& sensors, const Stance& stance = {}) {
    times_[next_ % kTicks] = time;
    frames_[next_ % kTicks] = sensors;
    stances_[next_ % kTicks] = stance;
    ++next_;
  }
  bool empty() const { return next_ == 0; }
  // Latest tick with its joints replaced by those at `time`; default values when empty.
  SensorFrame at(TimeUs time) const;
  HeadRate headRate(TimeUs time) const;
  Stance stance(TimeUs time) const;

 private:
  static constexpr std::size_t kTicks = 32;
  struct Places {  // of ticks, counted since the start
    std::size_t oldest;
    std::size_t older;
    std::size_t newer;
  };
  struct Span {
    const SensorFrame* older;
    const SensorFrame* newer;
    TimeUs start;
    double seconds;  // between the two
  };
  // The last tick before the time and the next; beyond the newest, that one and the fourth before.
  Places placesAt(TimeUs time) const;
  Span between(std::size_t older, std::size_t newer) const;
  // How far the time is on the way from the one to the other, beyond it at most by 100 ms.
  double partWay(const Places& places, TimeUs time) const;

  std::array<TimeUs, kTicks> times_{};
  std::array<SensorFrame, kTicks> frames_{};
  std::array<Stance, kTicks> stances_{};
  std::size_t next_ = 0;
};

}  // namespace kelpie::agent
