// SPDX-License-Identifier: Apache-2.0
// What stands on the carpet: goals, beacons, and walls that are put up during a match. Each is a
// slot of the model; an empty slot touches nothing.
#pragma once

#include <string>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "robot/core/Expected.h"
#include "tools/sim/physics/Engine.h"
#include "tools/sim/world/Ball.h"

namespace kelpie::sim {

// Empty slots: those of the field's own things and as many more as an outer wall has sides.
std::string thingSlotsXml(const body::FieldDescription& field);

// Fills the slots with these and no others. Error: more than there are slots; nothing has changed.
Status putThings(const std::vector<Obstacle>& things, const body::FieldDescription& field,
                 Engine& engine);

}  // namespace kelpie::sim
