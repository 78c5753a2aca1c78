// SPDX-License-Identifier: Apache-2.0
// The name and the unit of a field in Python, from its field list: snake_case; angles in degrees
// with a name that ends in _deg, their squares in _deg2; times in seconds. Keeps nothing.
#pragma once

#include <string>

#include "robot/core/fields/FieldTypes.h"

namespace kelpie::behaviour {

std::string snakeCase(const char* name);

// Factor from the number stored to the number shown: 1, or degrees per radian, or its square.
double shownFactor(const char* unit);

// The suffix for a number with that unit: "", "_deg" or "_deg2".
const char* unitSuffix(const char* unit);

template <class T>
struct ScalarOf {
  using type = T;
};
template <class T, std::size_t N>
struct ScalarOf<std::array<T, N>> : ScalarOf<T> {};
template <class T, std::size_t N>
struct ScalarOf<FixedVector<T, N>> : ScalarOf<T> {};

template <class Member>
std::string pythonName(const char* name, const char* unit) {
  using Scalar = typename ScalarOf<Member>::type;
  std::string text = snakeCase(name);
  if constexpr (std::is_same_v<Scalar, Angle>) text += "_deg";
  if constexpr (std::is_same_v<Scalar, TimeUs>) text += "_s";
  if constexpr (std::is_same_v<Scalar, double>) text += unitSuffix(unit);
  return text;
}

}  // namespace kelpie::behaviour
