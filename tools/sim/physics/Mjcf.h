// SPDX-License-Identifier: Apache-2.0
// The physical world as MuJoCo's XML: robots by the lengths of robot/body, ball, goals, beacons and
// carpet by the field description. Axes are Kelpie's: the field's for the world (in m), the torso's
// (right, ahead, up from the middle of the front shoulder axis) for each robot, so that joint
// angles and signs are those of robot/core/types/Joints.h. Robots do not touch themselves; the tail
// is left out.
#pragma once

#include <string>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "tools/sim/physics/PhysicsParams.h"

namespace kelpie::sim {

// One robot's own parameters: no two are alike.
using RobotsPhysics = std::vector<PhysicsParams>;

// Names: "r0_trunk", "r0_<joint index>", "r0_paw<leg>", "ball", "carpet"; what stands on the carpet
// are empty slots until it is put there (Things.h).
std::string worldXml(const body::FieldDescription& field, const RobotsPhysics& robots,
                     const PhysicsParams& world);

}  // namespace kelpie::sim
