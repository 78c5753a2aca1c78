// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/camera/RandomTables.h"

#include "robot/core/Random.h"
#include "robot/core/types/Image.h"

namespace kelpie::sim {
namespace {

constexpr std::uint64_t kTextureSeed = 71;
constexpr std::uint64_t kNoiseSeed = 20060618;

}  // namespace

SharedTables makeRandomTables() {
  auto tables = std::make_shared<RandomTables>();
  Random texture(kTextureSeed);
  tables->texture.resize(kTexels * kTexels);
  for (float& value : tables->texture) value = static_cast<float>(texture.uniform(-1.0, 1.0));
  Random noise(kNoiseSeed);
  tables->noise.resize(kNoises + kImageHeight);
  for (float& value : tables->noise) value = static_cast<float>(noise.gaussian());
  return tables;
}

}  // namespace kelpie::sim
