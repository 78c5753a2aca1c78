// SPDX-License-Identifier: Apache-2.0
// Reads the trace of a Command: a list of tuples (layer, module, branch, reason, number...). It is
// read in every frame, so straight from the objects, without a name looked up and without heap.
// Texts, steps and numbers beyond what a Trace holds are cut off; an infinite number becomes the
// largest of its range, for a distance may be that.
#pragma once

#include <string>

#include "behaviour/PythonRef.h"
#include "robot/core/types/Command.h"

namespace kelpie::behaviour {

// On failure `why` names the step and what is wrong, "[2].reason is a float, not a text".
bool readTrace(PyObject* object, Trace& trace, std::string& why);

}  // namespace kelpie::behaviour
