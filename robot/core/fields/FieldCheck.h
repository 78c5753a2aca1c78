// SPDX-License-Identifier: Apache-2.0
// Field by field: where two values first differ (bits, not tolerance, as replays must repeat), and
// whether a value is finite and in the ranges of its field list. Both name the place as
// "percepts.landmarks[2].distance".
#pragma once

#include <string>

#include "robot/core/fields/MemberType.h"

namespace kelpie {

namespace detail {

// Of a scalar: angles in radians, times in microseconds.
double numberOf(const MemberType& type, const void* value);

bool firstDifference(const MemberType& type, const void* a, const void* b, std::string* path);
bool verify(const MemberType& type, const void* value, std::string* why);

}  // namespace detail

// True when a and b differ in any bit of a field; path: "ball.distance: 100.5 != 100.6".
template <class T>
bool firstDifference(const T& a, const T& b, std::string* path) {
  return detail::firstDifference(memberTypeOf<T>(), &a, &b, path);
}

// True when every number is finite and in range; why: "ball.distance: -3 cm is outside 0..1000".
template <class T>
bool verify(const T& value, std::string* why) {
  return detail::verify(memberTypeOf<T>(), &value, why);
}

}  // namespace kelpie
