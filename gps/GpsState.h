// SPDX-License-Identifier: Apache-2.0
// What the localiser remembers between frames. Plain data: a copy is a snapshot, and GpsState{} is
// the state before the first frame.
#pragma once

#include "gps/BallState.h"
#include "gps/LineState.h"
#include "gps/PinkState.h"
#include "gps/PlayersState.h"
#include "gps/PoseState.h"

namespace kelpie::gps {

struct GpsState {
  PoseState pose;
  LinesState lines;
  PinkState pinks;
  BallState ball;
  PlayersState players;
  GpsCounts counts;
};

}  // namespace kelpie::gps
