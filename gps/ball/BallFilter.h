// SPDX-License-Identifier: Apache-2.0
// The ball over time: a Kalman filter of position and velocity in the robot frame. It needs no
// pose, so a lost robot still knows its ball. A jump (kick, bounce, false ball) is believed at the
// second sighting, or at once after an own kick; an unseen ball is given up after a while, sooner
// when it should be in the image. A held ball is where the body feels it.
#pragma once

#include "gps/ball/BallFilterParams.h"
#include "gps/ball/BallState.h"
#include "gps/pose/Predict.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Percepts.h"

namespace kelpie::gps {

struct BallIn {
  const FrameInput& input;
  const BallPercept& percept;
  const Step& moved;  // by the robot
};

void stepBall(const BallIn& in, const BallFilterParams& params, BallState& state,
              GpsCounts& counts);

}  // namespace kelpie::gps
