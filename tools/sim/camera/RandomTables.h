// SPDX-License-Identifier: Apache-2.0
// Fixed random numbers of cameras: the carpet's texture and long rows of noise. The cameras of a
// match share them, since one copy stays in a processor's cache and eight do not.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace kelpie::sim {

struct RandomTables {
  std::vector<float> texture;  // kTexels x kTexels, -1 to 1
  std::vector<float> noise;    // kNoises and an image's rows more; normal with sd 1
};

constexpr std::size_t kTexels = 128;  // a power of two
constexpr std::size_t kNoises = 1U << 16;

using SharedTables = std::shared_ptr<const RandomTables>;
// The same each time.
SharedTables makeRandomTables();

}  // namespace kelpie::sim
