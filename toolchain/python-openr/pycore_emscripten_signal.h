/* SPDX-License-Identifier: Apache-2.0
 * Takes the place of CPython's header of this name, a hook of the interpreter's loop for systems
 * that send no signals: the steps are counted there (behaviour/frozen/Steps.h), and wherever Python
 * looks for signals in its own long work, as it does in the arithmetic of large numbers.
 */
#pragma once

extern void kelpieStep(void);

#define _Py_CHECK_EMSCRIPTEN_SIGNALS() kelpieStep()
#define _Py_CHECK_EMSCRIPTEN_SIGNALS_PERIODICALLY() kelpieStep()
