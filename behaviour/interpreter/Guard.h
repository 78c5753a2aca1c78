// SPDX-License-Identifier: Apache-2.0
// The host's own Python: loads the behaviours into a closed world of modules and describes errors.
#pragma once

namespace kelpie::behaviour {

const char* guardText();  // the text of behaviour/interpreter/guard.py

}  // namespace kelpie::behaviour
