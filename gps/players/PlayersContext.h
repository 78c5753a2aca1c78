// SPDX-License-Identifier: Apache-2.0
// What the beliefs about players read of the parameters, and the field.
#pragma once

#include "gps/ball/BallFilterParams.h"
#include "gps/players/PlayersParams.h"
#include "robot/body/FieldDescription.h"

namespace kelpie::gps {

struct PlayersContext {
  const body::FieldDescription& field;
  const PlayersParams& players;
  const BallFilterParams& ball;  // how a mate's ball rolls on
};

}  // namespace kelpie::gps
