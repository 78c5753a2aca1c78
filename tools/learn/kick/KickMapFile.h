// SPDX-License-Identifier: Apache-2.0
// A kick map as the Python module that the behaviours read (pycode/data/kick_map.py), numbers
// rounded to what their spread makes significant, and read again from its text.
#pragma once

#include <string>

#include "tools/learn/kick/KickMapLearning.h"

namespace kelpie::learn {

// `about`: the command, a line or more.
std::string kickMapText(const KickMap& map, const std::string& about);

using sim::readKickMap;

}  // namespace kelpie::learn
