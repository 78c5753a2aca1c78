// SPDX-License-Identifier: Apache-2.0
// Fills any struct with a field list with random content: every number finite and in range, every
// FixedVector of random length, every Text of whole characters.
#pragma once

#include <algorithm>
#include <array>
#include <string>

#include "robot/core/Random.h"
#include "robot/core/fields/FieldTypes.h"

namespace kelpie {

template <class T>
void randomise(T& value, Random& random, double min = -1e6, double max = 1e6) {
  if constexpr (std::is_same_v<T, bool>) {
    value = random.chance(0.5);
  } else if constexpr (std::is_same_v<T, TimeUs>) {
    value.us = static_cast<std::int64_t>(random.next() >> 12);
  } else if constexpr (std::is_same_v<T, Angle>) {
    value = Angle::deg(random.uniform(std::max(min, -179.0), std::min(max, 179.0)));
  } else if constexpr (std::is_floating_point_v<T>) {
    value = static_cast<T>(random.uniform(std::max(min, -1e6), std::min(max, 1e6)));
  } else if constexpr (std::is_enum_v<T> || std::is_integral_v<T>) {
    const double low = std::max(min, 0.0);
    const double high = std::min(max, 255.0);
    value = static_cast<T>(low + random.index(static_cast<std::uint32_t>(high - low) + 1));
  } else if constexpr (IsText<T>::value) {
    constexpr std::array<const char*, 4> kCharacters{"a", " ", "\u00e9", "\U0001F415"};
    std::string text;
    const std::uint32_t length = random.index(static_cast<std::uint32_t>(T::kCapacity) + 1);
    for (std::uint32_t i = 0; i < length; ++i) text += kCharacters[random.index(4)];
    value.assign(text);
  } else if constexpr (kIsSequence<T>) {
    if constexpr (IsFixedVector<T>::value) {
      value.resize(random.index(static_cast<std::uint32_t>(T::kCapacity) + 1));
    }
    for (auto& item : value) randomise(item, random, min, max);
  } else {
    forEachField(value, [&](const auto& f, auto& m) { randomise(m, random, f.min, f.max); });
  }
}

}  // namespace kelpie
