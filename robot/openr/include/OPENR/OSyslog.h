// SPDX-License-Identifier: Apache-2.0
// Text for people, in the manner of printf, with its arguments in double parentheses. A line has at
// most 243 characters, the rest is cut (openr.md 3.4 and 5.5).
#pragma once

constexpr int osyslogERROR = 1;
constexpr int osyslogWARNING = 2;
constexpr int osyslogINFO = 3;
constexpr int osyslogMAX_LENGTH = 243;

void OSyslogPrint(const char* format, ...) __attribute__((format(printf, 1, 2)));
void OSyslogLevel(int level, const char* format, ...) __attribute__((format(printf, 2, 3)));

#define OSYSPRINT(arguments) OSyslogPrint arguments
#define OSYSLOG1(arguments) OSyslogLevel arguments
#define OSYSDEBUG(arguments) static_cast<void>(0)
