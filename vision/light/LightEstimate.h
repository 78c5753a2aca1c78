// SPDX-License-Identifier: Apache-2.0
// What light it is, over that which the colour table was made for, from what carpet, lines and
// landmarks looked like in the last seconds. A Gaussian of two numbers, the logarithms of the
// brightness and of how much more colours changed, with a prior about the table's own light. Fails
// where carpet and lines are both painted otherwise than the parameters say, by their share.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "robot/core/types/CameraLight.h"
#include "vision/light/LightParams.h"

namespace kelpie::vision {

enum class LightSource : std::uint8_t { carpet, line, landmark };
constexpr std::size_t kLightSources = 3;

// Logarithms of what an image shows of one kind of surface over what is expected.
struct LightSighting {
  bool seen = false;
  double brightness = 0.0;
  double colour = 0.0;
};
using LightSightings = std::array<LightSighting, kLightSources>;

// What an image says of the landmarks' own light.
enum class LandmarkLook : std::uint8_t { unknown, missing, even, glare };

struct SeenLight {
  LightSightings surfaces;
  LandmarkLook landmarks = LandmarkLook::unknown;  // unknown where none need show
};

// Sightings are of pixels that were divided by `light.applied` before.
void remember(const LightSightings& seen, const LightParams& params, CameraLight& light);
LightGains estimatedLight(const CameraLight& light, const LightParams& params);

}  // namespace kelpie::vision
