// SPDX-License-Identifier: Apache-2.0
// One ERS-7 as MuJoCo's XML, and the parts that the rest of the world's XML shares with it.
#pragma once

#include <string>

#include "tools/sim/physics/PhysicsParams.h"

namespace kelpie::sim {

// Bits of who touches whom: the ground and what stands on it, the ball, then one for each robot.
constexpr unsigned kThingsBit = 1;
constexpr unsigned kBallBit = 2;
constexpr unsigned robotBit(std::size_t robot) { return 4U << robot; }
constexpr unsigned kAllBits = 0x3ff;

// kg m2 about the centre of an even box of such sides, as MJCF's diaginertia.
std::string boxInertia(double mass, double x, double y, double z);

std::string robotXml(std::size_t robot, const PhysicsParams& params);
std::string servosXml(std::size_t robot, const ServoParams& params);

// The servo of a joint, its proportional gain included.
Servo servoOf(std::size_t joint, const ServoParams& params);

}  // namespace kelpie::sim
