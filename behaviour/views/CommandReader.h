// SPDX-License-Identifier: Apache-2.0
// Reads the Command that a script returned: every member must have the right type and be finite;
// then it is clamped to the range of its field list.
#pragma once

#include <string>
#include <vector>

#include "behaviour/PythonRef.h"
#include "robot/core/types/Command.h"

namespace kelpie::behaviour {

// Keeps the names of all members in Python, made once: spelling them in every frame cost more than
// the reading.
class CommandReader {
 public:
  CommandReader();  // needs an interpreter

  // On failure `why` names the member and what is wrong; `command` is then half filled.
  bool read(PyObject* object, Command& command, std::string& why) const;

 private:
  std::vector<PythonRef> names_;  // in the order of the field lists, a struct's before its members'
};

}  // namespace kelpie::behaviour
