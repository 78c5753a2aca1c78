// SPDX-License-Identifier: Apache-2.0
// The three files that tell OPEN-R of the agent: which objects to start, which of their services to
// join, and where data lie (spec openr.md section 6).
#pragma once

#include "tools/stick/StickTree.h"

namespace kelpie::stick {

StickTree systemFiles();

// VRCOMM.CFG with the word that has the robot wait longer before it takes a joint for jammed.
TreeFile relaxedJams();

}  // namespace kelpie::stick
