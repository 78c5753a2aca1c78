// SPDX-License-Identifier: Apache-2.0
// Copies frame structs and sets them back to their defaults by what their lists hold, not by what
// these have room for: most are nearly empty, and the Percepts alone have room for 17 KB, the size
// of the target's first-level cache.
#pragma once

#include <algorithm>

#include "robot/core/FixedVector.h"
#include "robot/core/ScratchVector.h"
#include "robot/core/fields/Fields.h"

namespace kelpie {

template <class T, std::size_t Capacity>
void copyUsed(FixedVector<T, Capacity>& to, const FixedVector<T, Capacity>& from) {
  to.resize(from.size());
  std::copy(from.begin(), from.end(), to.begin());
}
template <class T, std::size_t Capacity>
void copyUsed(FixedVector<T, Capacity>& to, const ScratchVector<T, Capacity>& from) {
  to.resize(from.size());
  std::copy(from.begin(), from.end(), to.begin());
}
template <class T>
void copyUsed(T& to, const T& from) {
  to = from;
}

template <class T, std::size_t Capacity>
void makeDefault(FixedVector<T, Capacity>& list) {
  list.clear();
}
template <class T>
void makeDefault(T& value) {
  value = T{};
}

// The same as `object = S{}` where no member of S itself has another default than its type has.
template <class S>
void makeEmpty(S& object) {
  forEachField(object, [](const auto&, auto& member) { makeDefault(member); });
}

}  // namespace kelpie
