// SPDX-License-Identifier: Apache-2.0
// TOML files of any content, by toml++ without exceptions. Host only. Its parser takes two kinds of
// wrong files for impossible: those at which it would end the program by an assertion ("[[[a]") are
// reported by the code behind the assertions, which are off; letters beyond ASCII where a key or
// number may stand, for which the compiler is promised that they do not come, are reported here.
#pragma once

#include <string>

#include "robot/core/Expected.h"

#define TOML_EXCEPTIONS 0
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>

namespace kelpie {

// Errors are one line: "path: what", "path:line: what".
Expected<toml::table> readToml(const std::string& path);

// What is said of a file with its own words in it, quoted keys for example: with a blank for each
// end of line or other control character.
Error inOneLine(std::string error);

}  // namespace kelpie
