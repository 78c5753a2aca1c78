// SPDX-License-Identifier: Apache-2.0
// How much of its stick a robot reads before it plays, counted, and how long that takes at the
// speeds that are public for the medium. Nobody has measured one in a robot.
#pragma once

#include <cstddef>
#include <string>

#include "tools/stick/StickTree.h"

namespace kelpie::stick {

struct BootReads {
  std::size_t reads = 0;  // of at most kBlockBytes
  std::size_t bytes = 0;
};

// By the robot's reader, and, when its player is that, by Python, which reads PYCODE.ZIP again.
// What the system reads before, AGENT.BIN and its own files, is not in it.
BootReads bootReads(const StickTree& tree, bool python);

// For people.
std::string bootLine(const BootReads& reads);

}  // namespace kelpie::stick
