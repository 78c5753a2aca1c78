// SPDX-License-Identifier: Apache-2.0
// The last sixteen sensed ticks, to tell where the joints were in the middle of an exposure, how
// fast the head turned and how the body stood. Beyond the newest tick the angles are extrapolated
// for at most 20 ms.
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
  static constexpr std::size_t kTicks = 16;
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
  Places placesAt(TimeUs time) const;  // the last tick before the time and the next
  Span between(std::size_t older, std::size_t newer) const;
  // How far the time is on the way from the one to the other, beyond it at most by 20 ms.
  double partWay(const Places& places, TimeUs time) const;

  std::array<TimeUs, kTicks> times_{};
  std::array<SensorFrame, kTicks> frames_{};
  std::array<Stance, kTicks> stances_{};
  std::size_t next_ = 0;
};

}  // namespace kelpie::agent
