// SPDX-License-Identifier: Apache-2.0
// The names under which refusals are counted in logs: a table of a stage's own enum of reasons, in
// the order of its numbers, which are the places in the log's counts.
#pragma once

#include <cstddef>

namespace kelpie {

template <typename Refusal>
struct RefusalName {
  Refusal refusal;
  const char* name;
};

template <typename Refusal, std::size_t N>
constexpr bool areInOrder(const RefusalName<Refusal> (&names)[N]) {
  for (std::size_t i = 0; i < N; ++i)
    if (static_cast<std::size_t>(names[i].refusal) != i) return false;
  return true;
}

}  // namespace kelpie
