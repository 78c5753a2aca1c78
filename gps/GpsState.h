// SPDX-License-Identifier: Apache-2.0
// What the localiser remembers between frames. Plain data: a copy is a snapshot, and GpsState{} is
// the state before the first frame.
#pragma once

#include "gps/ball/BallState.h"
#include "gps/lines/LineState.h"
#include "gps/pinks/PinkState.h"
#include "gps/players/PlayersState.h"
#include "gps/pose/PoseState.h"

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
