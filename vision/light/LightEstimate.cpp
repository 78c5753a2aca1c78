// SPDX-License-Identifier: Apache-2.0
#include "vision/light/LightEstimate.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"

namespace kelpie::vision {
namespace {

// The information form of a Gaussian of (brightness, colour beyond it).
struct Information {
  double matrix[3]{};  // brightness, both, colour
  double vector[2]{};

  void addBrightness(double value, double variance) {
    matrix[0] += 1.0 / variance;
    vector[0] += value / variance;
  }
  // Of the colour as it is seen, which is brightness and what is beyond it together.
  void addColour(double value, double variance) {
    for (double& m : matrix) m += 1.0 / variance;
    for (double& v : vector) v += value / variance;
  }
};

// By LightSource.
constexpr std::array<LightMemory CameraLight::*, kLightSources> kMemories{
    &CameraLight::carpet, &CameraLight::line, &CameraLight::landmark};

double sdOf(LightSource source, const LightParams& params) {
  if (source == LightSource::carpet) return params.carpetSd;
  return source == LightSource::line ? params.lineSd : params.landmarkSd;
}

double within(const LightParams& params, double logarithm) {
  return maths::clamp(maths::exp(logarithm), params.least, params.most);
}

}  // namespace

void remember(const LightSightings& seen, const LightParams& params, CameraLight& light) {
  const double brightness = maths::log(light.applied.brightness);
  const double colour = maths::log(light.applied.colour);
  for (std::size_t i = 0; i < kLightSources; ++i) {
    if (!seen[i].seen) continue;
    LightMemory& memory = light.*kMemories[i];
    memory.images = std::min(memory.images + 1.0, params.memory);
    memory.brightness += (seen[i].brightness + brightness - memory.brightness) / memory.images;
    memory.colour += (seen[i].colour + colour - memory.colour) / memory.images;
  }
}

LightGains estimatedLight(const CameraLight& light, const LightParams& params) {
  Information sum;
  sum.matrix[0] = 1.0 / maths::square(params.brightnessSd);
  sum.matrix[2] = 1.0 / maths::square(params.colourSd);
  for (std::size_t i = 0; i < kLightSources; ++i) {
    const LightMemory& memory = light.*kMemories[i];
    if (memory.images < 1.0) continue;
    const auto source = static_cast<LightSource>(i);
    const double variance =
        maths::square(sdOf(source, params)) + maths::square(params.frameSd) / memory.images;
    sum.addBrightness(memory.brightness, variance);
    if (source != LightSource::line) sum.addColour(memory.colour, variance);
  }
  const double* m = sum.matrix;
  const double determinant = m[0] * m[2] - m[1] * m[1];
  const double brightness = (m[2] * sum.vector[0] - m[1] * sum.vector[1]) / determinant;
  const double beyond = (m[0] * sum.vector[1] - m[1] * sum.vector[0]) / determinant;
  return {within(params, brightness), within(params, brightness + beyond)};
}

}  // namespace kelpie::vision
