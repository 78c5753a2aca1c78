// SPDX-License-Identifier: Apache-2.0
// Conversions between people's units and OPEN-R's micro-units (openr.md 5.5).
#pragma once

#include "Types.h"

inline slongword micro(double value) { return static_cast<slongword>(value * 1e6); }
inline double radians(double inDegrees) { return inDegrees * (3.14159265358979323846 / 180.0); }
inline double degrees(double inRadians) { return inRadians * (180.0 / 3.14159265358979323846); }
inline slongword oradians(double inDegrees) { return micro(radians(inDegrees)); }
