// SPDX-License-Identifier: Apache-2.0
// What kicks do with the ball in the kinematic world: pycode/data/kick_map.py, which `kelpie
// calibrate kicks` measured on varied physical models, compiled in. A step beyond the outermost
// places no ball goes any more [chosen]. Fails for a ball that rolls.
#pragma once

#include <optional>

#include "tools/sim/kicks/KickMap.h"

namespace kelpie::sim {

const char* standardKickMapText();
const KickMap& standardKickMap();

// Of a ball that lies there, in the frame of the robot as its kick begins, or of one that it holds.
// The spreads are those of a ball whose place is known, so less than the map's. Nothing for a
// motion that the map does not have from there.
std::optional<KickCell> freeKick(MotionKind kind, bool walks, Point2<Robot> ball);
std::optional<KickCell> heldKick(MotionKind kind);

}  // namespace kelpie::sim
