// SPDX-License-Identifier: Apache-2.0
// The ball as a landmark: where a mate that is surer of it says that it lies, and where this robot
// sees it, correct this robot's pose. In a scrum nobody sees a beacon, but nearly always the ball.
// Fails where the two see different balls; each mode leaves a copy that is not corrected. What a
// robot tells of the ball then holds some of what it heard, but only of who was so much surer that
// it seldom comes back to him (BallLandmarkParams::surer).
#pragma once

#include "gps/ball/BallState.h"
#include "gps/players/PlayersContext.h"
#include "gps/players/PlayersState.h"
#include "gps/pose/PoseState.h"

namespace kelpie::gps {

// By the first new message whose sender is surer of the ball; the others wait for the next frame.
// Adds to each mode its copy: the caller merges. False when no message corrects.
bool correctByBall(const BallTrack& own, const PlayersContext& context, PlayersState& players,
                   Modes& modes);

}  // namespace kelpie::gps
