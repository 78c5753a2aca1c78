// SPDX-License-Identifier: Apache-2.0
// One line for a driver: the time, what holds the robot up, what it was commanded, does and sees.
// What matters most stands first, since a narrow terminal cuts the end off. Keeps nothing.
#pragma once

#include <string>

#include "robot/host/world/DriverProtocol.h"

namespace kelpie::teleop {

// "12.3 s  ahead 10 cm/s  ball 85 cm 12 deg left  head 15 deg left 20 deg down"
std::string statusLine(const host::DriverView& view);

}  // namespace kelpie::teleop
