/* SPDX-License-Identifier: Apache-2.0
 * Takes the place of CPython's header of this name and includes it: of the interpreter's probes the
 * one at each return of a function of Python counts a step, all others are empty as they were.
 */
#pragma once

#include <Include/pydtrace.h>

extern void kelpieStep(void);

#define PyDTrace_FUNCTION_RETURN_ENABLED() (kelpieStep(), 0)
