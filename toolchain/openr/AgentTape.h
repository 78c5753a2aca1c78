// SPDX-License-Identifier: Apache-2.0
// What passes between the OPEN-R object and its loops, as toolchain/emulate plays it: records of a
// tape (objectStories.cpp) and what the emulated image answers (emulated/Probe.cpp).
#pragma once

#include "robot/agent/joints/Motors.h"
#include "robot/core/types/Image.h"
#include "robot/core/types/Motion.h"

namespace kelpie::tape {

// An image as it came.
struct Moment {
  TimeUs exposed;
  std::uint32_t number = 0;
  Image image;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("exposed", &Moment::exposed, "us"), field("number", &Moment::number),
                     field("image", &Moment::image));
  }
};

// What the loops answered a message of the sensors.
struct Answer {
  MotionOutput motion;
  agent::MotorsOut motors;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("motion", &Answer::motion), field("motors", &Answer::motors));
  }
};

}  // namespace kelpie::tape
