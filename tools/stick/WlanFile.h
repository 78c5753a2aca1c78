// SPDX-License-Identifier: Apache-2.0
// The radio's settings, KEY=VALUE a line, as the robot reads them from WLANCONF.TXT. The file holds
// keys: it lies outside the repository, and no message repeats a value.
#pragma once

#include <string>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie::stick {

struct WlanSettings {
  std::string text;                  // of WLANCONF.TXT
  std::vector<std::string> unknown;  // keys in it whose values nobody has checked
};

// The settings of a file's text: its keys in their order, without comments, blank lines and keys of
// nothing, as HOSTNAME= or WEPKEY= beside WEPENABLE=0: nobody here knows how the robot reads those,
// and to it a key that is not there is one that is not set. A key that is not known here is kept as
// it is, because Sony's own samples have more keys than their documents tell of. The error names
// the line and the key, never the value.
Expected<WlanSettings> wlanSettings(const std::string& text, const std::string& file);

// Refuses a file inside the source tree.
Expected<WlanSettings> readWlanFile(const std::string& file);

// For people: which keys were kept unchecked; empty when there is none.
std::string unknownKeysLine(const WlanSettings& settings, const std::string& file);

}  // namespace kelpie::stick
