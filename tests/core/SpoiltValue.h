// SPDX-License-Identifier: Apache-2.0
// Puts what no sensor gives into any struct with a field list: NaN, infinities, numbers far
// too large or too small. Whole numbers, times and list lengths stay.
#pragma once

#include <array>
#include <limits>

#include "tests/core/RandomValue.h"

namespace kelpie {

inline double nasty(Random& random) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  constexpr std::array<double, 14> kNasty = {std::numeric_limits<double>::quiet_NaN(),
                                             kInf,
                                             -kInf,
                                             0.0,
                                             -0.0,
                                             -1.0,
                                             1e-300,
                                             1e300,
                                             -1e300,
                                             1e9,
                                             -1000.0,
                                             1000.0,
                                             1e-9,
                                             3e38};
  return kNasty[random.index(static_cast<std::uint32_t>(kNasty.size()))];
}

// One number of every `rarity`, on average.
template <class T>
void spoil(T& value, Random& random, std::uint32_t rarity) {
  if constexpr (std::is_same_v<T, Angle>) {
    if (random.index(rarity) == 0) value = Angle::rad(nasty(random));
  } else if constexpr (std::is_floating_point_v<T>) {
    if (random.index(rarity) == 0) value = static_cast<T>(nasty(random));
  } else if constexpr (kIsSequence<T>) {
    for (auto& item : value) spoil(item, random, rarity);
  } else if constexpr (HasFields<T>::value) {
    forEachField(value, [&](const auto&, auto& member) { spoil(member, random, rarity); });
  }
}

}  // namespace kelpie
