// SPDX-License-Identifier: Apache-2.0
// The numbers of a struct as a row and back, in the order of its fields.
#pragma once

#include <vector>

#include "robot/core/fields/Fields.h"

namespace kelpie::learn {

template <class S, class F>
void forEachNumber(S& values, F f) {
  forEachField(values, [&](const auto&, auto& member) {
    if constexpr (HasFields<std::decay_t<decltype(member)>>::value) {
      forEachNumber(member, f);
    } else {
      f(member);
    }
  });
}

template <class S>
std::vector<double> numbersOf(const S& values) {
  std::vector<double> row;
  forEachNumber(values, [&](const double& number) { row.push_back(number); });
  return row;
}

}  // namespace kelpie::learn
