// SPDX-License-Identifier: Apache-2.0
// What light it is, over that which the colour table was made for, from what carpet, lines and
// landmarks looked like in the last seconds. A Gaussian of two numbers, the logarithms of the
// brightness and of how much more colours changed, with a prior about the table's own light. Fails
// where carpet and lines are both painted otherwise than the parameters say, by their share.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "vision/light/LightParams.h"

namespace kelpie::vision {

// Of Y, and of Cr and Cb about grey.
struct LightGains {
  double brightness = 1.0;
  double colour = 1.0;
};

enum class LightSource : std::uint8_t { carpet, line, landmark };
constexpr std::size_t kLightSources = 3;

// Logarithms of what an image shows of one kind of surface over what is expected.
struct LightSighting {
  bool seen = false;
  double brightness = 0.0;
  double colour = 0.0;
};
using LightSightings = std::array<LightSighting, kLightSources>;

struct LightMemory {
  double images = 0.0;  // that the means are of; no more than `memory`
  double brightness = 0.0;
  double colour = 0.0;
};
using LightMemories = std::array<LightMemory, kLightSources>;

// Sightings are of pixels that were divided by `applied` before.
void remember(const LightSightings& seen, const LightGains& applied, const LightParams& params,
              LightMemories& memories);
LightGains estimatedLight(const LightMemories& memories, const LightParams& params);

}  // namespace kelpie::vision
