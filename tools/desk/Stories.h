// SPDX-License-Identifier: Apache-2.0
// What happens to a robot on a desk between switching on and switching off, as scripts: what
// toolchain/emulate plays to the robot's object in the emulator, and this PC beside it.
#pragma once

#include <functional>
#include <vector>

#include "tools/desk/Desk.h"

namespace kelpie::desk {

struct Event {
  double at = 0.0;  // s
  std::function<void(host::Desk&, host::WatchedSystem&)> happens;
};

struct Story {
  const char* name = "";
  double seconds = 0.0;
  std::vector<Event> events;  // in the order of time
};

// start, pause, jam, empty battery, pick-up, shutdown.
std::vector<Story> stories();

// Sprawled, as somebody put it there.
JointAngles sprawled();

}  // namespace kelpie::desk
