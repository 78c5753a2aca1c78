// SPDX-License-Identifier: Apache-2.0
// The end of a process whose script is in one long call of Python's own, which nothing breaks off,
// as sum(range(10 ** 9)): one line for people that says where, as far as that can be found out, and
// the exit code that whoever started the process knows (HungExit.h). Runs inside a signal handler,
// so it asks no memory of anybody, and of Python only what a handler may.
#pragma once

#include <Python.h>

namespace kelpie::behaviour {

// `thread`: the one that runs the script.
[[noreturn]] void endHung(PyThreadState* thread, int exitCode);

}  // namespace kelpie::behaviour
