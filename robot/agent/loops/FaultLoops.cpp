// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/loops/FaultLoops.h"

#include "robot/body/Lights.h"

namespace kelpie::agent {

const MotionOutput& FaultLoops::motion(const MotionInput& input) {
  const Cause cause = step(CausesIn{input.time, power_}, CausesParams{}, causes_);
  if (cause.demand == Demand::switchOff) {
    motors_.reported = cause.rest;
    motors_.order.shutDown = true;
  }
  for (JointFrame& frame : output_.joints) {
    frame.target = input.sensors.back().joints;
    frame.leds = fault_ != 0 ? body::faultLights(fault_, input.time) : shown_;
  }
  return output_;
}

}  // namespace kelpie::agent
