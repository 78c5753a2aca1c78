// SPDX-License-Identifier: Apache-2.0
#include "robot/object/FaultLoops.h"

#include "robot/body/Lights.h"

namespace kelpie::object {

const MotionOutput& FaultLoops::motion(const MotionInput& input) {
  for (JointFrame& frame : output_.joints) {
    frame.target = input.sensors.back().joints;
    frame.leds = fault_ != 0 ? body::faultLights(fault_, input.time) : shown_;
  }
  return output_;
}

}  // namespace kelpie::object
