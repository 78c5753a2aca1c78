// SPDX-License-Identifier: Apache-2.0
// Conversions between people's units and OPEN-R's micro-units (openr.md 5.5).
#pragma once

#include "Types.h"

constexpr double oUNITS_PI = 3.14159265358979323846;

constexpr slongword micro(double value) { return static_cast<slongword>(value * 1e6); }
constexpr double radians(double inDegrees) { return inDegrees * (oUNITS_PI / 180.0); }
constexpr double degrees(double inRadians) { return inRadians * (180.0 / oUNITS_PI); }
constexpr slongword oradians(double inDegrees) { return micro(radians(inDegrees)); }
