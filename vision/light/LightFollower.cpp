// SPDX-License-Identifier: Apache-2.0
#include "vision/light/LightFollower.h"

#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::vision {
namespace {

constexpr double kMax = kByteValues - 1.0;

std::uint8_t asByte(double value) {
  return static_cast<std::uint8_t>(maths::clamp(value + 0.5, 0.0, kMax));
}

// What each corrected value is in the light that the table was made for.
void fill(const LightGains& gains, ChannelBytes& bytes) {
  for (std::size_t value = 0; value < kByteValues; ++value) {
    const double v = static_cast<double>(value);
    bytes.y[value] = asByte(v / gains.brightness);
    bytes.chroma[value] = asByte(kNeutralChroma + (v - kNeutralChroma) / gains.colour);
  }
}

double stepped(double from, double to, const LightParams& params) {
  const double step = maths::log(to / from);
  return from * maths::exp(maths::clamp(step, -params.mostStep, params.mostStep));
}

bool isWorthAStep(const LightGains& from, const LightGains& to, const LightParams& params) {
  return std::fabs(maths::log(to.brightness / from.brightness)) > params.leastStep ||
         std::fabs(maths::log(to.colour / from.colour)) > params.leastStep;
}

}  // namespace

void followLight(LightState& state, PixelTables& tables) {
  if (isWhole(state)) return;
  --state.partsToMake;
  tables.relight(state.bytes, static_cast<std::size_t>(state.partsToMake));
}

void learnLight(const LightSightings& seen, const LightParams& params, LightState& state) {
  remember(seen, state.applied, params, state.memories);
  const LightGains light = estimatedLight(state.memories, params);
  if (!isWorthAStep(state.applied, light, params)) return;
  state.applied = {stepped(state.applied.brightness, light.brightness, params),
                   stepped(state.applied.colour, light.colour, params)};
  fill(state.applied, state.bytes);
  state.partsToMake = static_cast<int>(kTableParts);
}

}  // namespace kelpie::vision
