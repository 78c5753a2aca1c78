// SPDX-License-Identifier: Apache-2.0
// The Python text of the module `kelpie`, written from the field lists: constants and the classes
// of the Command. With the world's classes it is the stand-in for a plain python3
// (tests/py/kelpie.py).
#pragma once

#include <string>

namespace kelpie::behaviour {

std::string kelpieModuleText();
std::string kelpieStandInText();  // the same and World and its parts, writable

}  // namespace kelpie::behaviour
