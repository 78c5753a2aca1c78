// SPDX-License-Identifier: Apache-2.0
// Files on a stick that ours would replace and that are not ours, and the folder of the stick in
// which they are kept. A stick is ours when OBJECT.CFG starts our agent alone and its STICK.BIN or
// its AGENT.BIN is of our making, in whatever version and however damaged: installing again is what
// mends it. On any other stick a file is another program's unless STICK.BIN lists it as it is. The
// settings of Sony's system are their owner's on every stick, whoever plays, unless it lists them.
#pragma once

#include "robot/core/Expected.h"
#include "tools/stick/medium/StickFolder.h"

namespace kelpie::stick {

// With their bytes as they are on the stick. An error when one cannot be read, and so not be kept.
Expected<StickTree> formerFiles(const StickTree& tree, const std::string& root);

// Whether another program's are among them, and not only settings of Sony's system.
bool haveAnotherProgram(const StickTree& former);

// "OPEN-R/MW/CONF/OBJECT.CFG, OPEN-R/MW/CONF/CONNECT.CFG"
std::string namesOf(const StickTree& files);

// Copies them to FORMER.001, or the next number that is free, on the medium when it returns: the
// name of the folder. One that has them all already, from an installation that was stopped, is
// taken as it is. A stop in the middle leaves KELPIE.NEW, which the next call removes.
Expected<std::string> keepFormer(const StickTree& former, const std::string& root,
                                 const StepObserver& step);

}  // namespace kelpie::stick
