// SPDX-License-Identifier: Apache-2.0
// Whether the camera is dead: no image for a second of the sensors' time. A robot that walks on by
// its last image walks off the field.
#pragma once

#include "robot/core/Time.h"

namespace kelpie::agent {

struct WatchdogParams {
  double seconds = 1.0;  // 30 images
};

struct WatchdogInput {
  TimeUs time;
  bool imageCame = false;  // since the last step
};

struct WatchdogState {
  bool began = false;
  TimeUs last;  // when the last image was reported, or the first step was
};

inline bool step(const WatchdogInput& in, const WatchdogParams& params, WatchdogState& state) {
  if (in.imageCame || !state.began) state.last = in.time;
  state.began = true;
  return (in.time - state.last).seconds() >= params.seconds;
}

}  // namespace kelpie::agent
