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

void learnLight(const LightSightings& seen, const LightParams& params, CameraLight& light) {
  remember(seen, params, light);
  const LightGains now = estimatedLight(light, params);
  if (!isWorthAStep(light.applied, now, params)) return;
  light.before = light.applied;
  light.applied = {stepped(light.applied.brightness, now.brightness, params),
                   stepped(light.applied.colour, now.colour, params)};
  light.partsToMake = static_cast<std::uint8_t>(kTableParts);
}

}  // namespace kelpie::vision
