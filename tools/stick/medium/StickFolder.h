// SPDX-License-Identifier: Apache-2.0
// A stick's files in a folder or on a mounted stick. Files are written into a folder KELPIE.NEW of
// it, synced and read back; only when all of them are good they take their places, STICK.BIN last.
// So a full disk, an error or a stop in the middle leaves the earlier files as they were, each
// whole; from the first file that replaces another to the last the robot's reader refuses the
// mixture, and installing again ends it.
// Nothing is ever formatted, and no file of Sony's is touched.
#pragma once

#include <functional>
#include <string>

#include "robot/core/Expected.h"
#include "tools/stick/StickTree.h"

namespace kelpie::stick {

// What is not finished lies in this folder of a stick and nowhere else; found there, it is what an
// installation left that was stopped, and goes.
constexpr const char* kUnfinished = "KELPIE.NEW";

// Hears of each step before it is done: "write OPEN-R/...", "rename OPEN-R/...".
using StepObserver = std::function<void(const std::string& step)>;

// Refuses what does not look like a programming stick : no OPEN-R folder with Sony's system, or
// none with a radio when the tree sets one.
Status checkMount(const StickTree& tree, const std::string& root);

// Refuses a folder with an AGENT.BIN, WLANCONF.TXT or VRCOMM.CFG that the tree lacks, and a
// programming stick.
Status checkFolder(const StickTree& tree, const std::string& root);

// Writes what differs, makes folders as needed.
Status writeFiles(const StickTree& tree, const std::string& root, const StepObserver& step);

}  // namespace kelpie::stick
