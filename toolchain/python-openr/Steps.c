// SPDX-License-Identifier: Apache-2.0
// Counts the steps of the interpreter (behaviour/frozen/Steps.h). The signal that it raises is not
// a system's: CPython calls the handler that the guard has set, in place of the next instruction.
#include "behaviour/frozen/Steps.h"

#include <Python.h>
#include <signal.h>

static uint32_t taken;
static uint32_t left;  // 0: not limited
static uint32_t then;

void kelpieLimitSteps(uint32_t steps, uint32_t again) {
  left = steps;
  then = again;
}

uint32_t kelpieStepsTaken(void) { return taken; }

void kelpieStep(void) {
  ++taken;
  if (left == 0 || --left != 0) return;
  left = then;
  PyErr_SetInterruptEx(SIGVTALRM);
}
