// SPDX-License-Identifier: Apache-2.0
#include "robot/object/FaultLoops.h"

#include "robot/body/Lights.h"

namespace kelpie::object {

const MotionOutput& FaultLoops::motion(const MotionInput& input) {
  output_.status.lowGain = true;
  for (JointFrame& frame : output_.joints) {
    if (!held_) frame.target = input.sensors.back().joints;
    frame.leds = body::faultLights(fault_, input.time);
  }
  held_ = true;
  return output_;
}

}  // namespace kelpie::object
