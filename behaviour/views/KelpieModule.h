// SPDX-License-Identifier: Apache-2.0
// The Python text of the module `kelpie`, written from the field lists: names, the constants, the
// Command and its parts. With the world's classes it is the stand-in for a plain python3
// (tests/py). Keeps nothing. Enums have no field list: their names are typed once more in
// KelpieModule.cpp.
#pragma once

#include <string>

namespace kelpie::behaviour {

std::string kelpieModuleText();
std::string kelpieStandInText();  // with WorldFrame and its parts, writable

}  // namespace kelpie::behaviour
