// SPDX-License-Identifier: Apache-2.0
// Reads the Command that a script returned: every member must have the right type and be finite;
// then it is clamped to the range of its field list.
#pragma once

#include <string>

#include "behaviour/PythonRef.h"
#include "robot/core/Command.h"

namespace kelpie::behaviour {

// On failure `why` names the member and what is wrong; `command` is then half filled.
bool readCommand(PyObject* object, Command& command, std::string& why);

}  // namespace kelpie::behaviour
