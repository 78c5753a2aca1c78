// SPDX-License-Identifier: Apache-2.0
// What the referee does with the ball: out of the field it comes back at the drop-in point, after a
// goal to the centre. A robot that did not see it happen believes the rule until it looks. Fails
// when the pose is wrong by more than its covariance: the ball is then found again by sight.
#pragma once

#include "gps/ball/BallFilterParams.h"
#include "gps/ball/BallState.h"
#include "gps/pose/PoseState.h"
#include "robot/body/FieldDescription.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie::gps {

// How far the whole ball is beyond the nearest line, cm; negative inside, and inside the goals.
double beyondLines(const body::FieldDescription& field, Point2<Field> ball);

void applyReferee(const GameState& game, const body::FieldDescription& field,
                  const BallFilterParams& params, const PoseState& pose, BallState& ball);

}  // namespace kelpie::gps
