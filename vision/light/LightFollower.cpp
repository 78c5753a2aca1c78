// SPDX-License-Identifier: Apache-2.0
#include "vision/light/LightFollower.h"

#include <cmath>

#include "robot/core/Maths.h"
#include "vision/pixels/PixelTables.h"

namespace kelpie::vision {
namespace {

double stepped(double from, double to, const LightParams& params) {
  const double step = maths::log(to / from);
  return from * maths::exp(maths::clamp(step, -params.mostStep, params.mostStep));
}

bool isWorthAStep(const LightGains& from, const LightGains& to, const LightParams& params) {
  return std::fabs(maths::log(to.brightness / from.brightness)) > params.leastStep ||
         std::fabs(maths::log(to.colour / from.colour)) > params.leastStep;
}

}  // namespace

void learnGlare(LandmarkLook seen, const LightParams& params, CameraLight& light) {
  if (seen == LandmarkLook::unknown) return;
  const bool asLookedFor =
      light.glare ? seen == LandmarkLook::glare : seen != LandmarkLook::missing;
  light.missing = asLookedFor ? 0 : static_cast<std::uint16_t>(light.missing + 1);
  if (light.missing < params.glareImages) return;
  light.glare = !light.glare;
  light.missing = 0;
}

void learnLight(const SeenLight& seen, const LightParams& params, CameraLight& light) {
  learnGlare(seen.landmarks, params, light);
  remember(seen.surfaces, params, light);
  const LightGains now = estimatedLight(light, params);
  if (!isWorthAStep(light.applied, now, params)) return;
  light.before = light.applied;
  light.applied = {stepped(light.applied.brightness, now.brightness, params),
                   stepped(light.applied.colour, now.colour, params)};
  light.partsToMake = static_cast<std::uint8_t>(kTableParts);
}

}  // namespace kelpie::vision
