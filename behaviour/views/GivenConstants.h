// SPDX-License-Identifier: Apache-2.0
// Hands the constants of a robot to its behaviours, as kelpie.constants; before they are loaded,
// since modules take theirs then. Keeps nothing.
#pragma once

#include "behaviour/Constants.h"
#include "behaviour/PythonRef.h"

namespace kelpie::behaviour {

// False, with a Python error set: no memory, or a module that is not this program's.
bool giveConstants(PyObject* kelpie, const Constants& constants);

}  // namespace kelpie::behaviour
