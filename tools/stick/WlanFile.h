// SPDX-License-Identifier: Apache-2.0
// The radio's settings, KEY=VALUE a line, as the robot reads them from WLANCONF.TXT (spec openr.md
// section 6). The file holds keys: it lies outside the repository, and no message repeats a value.
#pragma once

#include <string>

#include "robot/core/Expected.h"

namespace kelpie::stick {

// WLANCONF.TXT of the file's text: its keys in their order, comments and blank lines left out. The
// error names the line and the key, never the value.
Expected<std::string> wlanText(const std::string& text, const std::string& file);

// Refuses a file inside the source tree.
Expected<std::string> readWlanFile(const std::string& file);

}  // namespace kelpie::stick
