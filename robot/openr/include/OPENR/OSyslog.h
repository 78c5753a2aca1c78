// SPDX-License-Identifier: Apache-2.0
// Text for people, in the manner of printf, with its arguments in double parentheses. A line has at
// most 243 characters, the rest is cut (openr.md 3.4 and 5.5).
#pragma once

#include "OPENR/OPENR.h"

using OSyslogPriority = longword;
constexpr OSyslogPriority osyslogERROR = 1;
constexpr OSyslogPriority osyslogWARNING = 2;
constexpr OSyslogPriority osyslogINFO = 3;

// The robot's compiler does not check the format; here it is, which can only find more.
OStatus osysprint(const char* format, ...) __attribute__((format(printf, 1, 2)));
OStatus osyslog(OSyslogPriority priority, const char* format, ...)
    __attribute__((format(printf, 2, 3)));

#define OSYSPRINT(arguments) osysprint arguments
#define OSYSLOG1(arguments) osyslog arguments
#define OSYSDEBUG(arguments) static_cast<void>(0)
