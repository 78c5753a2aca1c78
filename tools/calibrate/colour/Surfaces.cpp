// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/colour/Surfaces.h"

#include <cmath>
#include <string>
#include <vector>

#include "robot/core/fields/FieldCheck.h"
#include "tools/calibrate/Quantile.h"
#include "vision/colour/ColourTable.h"

namespace kelpie::calibrate {
namespace {

// Pixels of one surface differ by some 10 levels, so a median of 20 is good to 3: the light is not
// followed by smaller steps (LightParams::leastStep).
constexpr std::size_t kMinPixels = 20;
// Vision takes no pixel with less for carpet (LightSightings.cpp), and divides by it.
constexpr double kMinChroma = 5.0;  // levels

vision::SurfaceColour medianOf(const std::vector<Yuv>& pixels) {
  const auto median = [&](std::uint8_t Yuv::*channel) {
    std::vector<double> values;
    values.reserve(pixels.size());
    for (const Yuv& p : pixels) values.push_back(p.*channel);
    return quantile(std::move(values), 0.5);
  };
  return {median(&Yuv::y), median(&Yuv::cr), median(&Yuv::cb)};
}

bool isColourless(const vision::SurfaceColour& c) {
  return std::hypot(c.cr - vision::kNeutralChroma, c.cb - vision::kNeutralChroma) < kMinChroma;
}

Expected<vision::SurfaceColour> colourOf(const LabelledPixels& pixels, const LitSurface& surface) {
  const std::string name = vision::kColourNames[vision::index(surface.colour)];
  std::vector<Yuv> values;
  for (const LabelledPixel& p : pixels)
    if (p.colour == surface.colour) values.push_back(p.value);
  if (values.size() < kMinPixels)
    return Error{std::to_string(values.size()) + " pixels are labelled " + name + ", " +
                 std::to_string(kMinPixels) + " tell its colour"};
  const vision::SurfaceColour colour = medianOf(values);
  const bool mayBeGrey = surface.colour == vision::ColourClass::white;
  if (!mayBeGrey && isColourless(colour))
    return Error{"what is labelled " + name + " is grey: it tells no light"};
  std::string why;
  if (!verify(colour, &why)) return Error{"what is labelled " + name + " is too dark: " + why};
  return colour;
}

}  // namespace

Expected<vision::LightParams> surfacesOf(const LabelledPixels& pixels) {
  vision::LightParams params;
  for (const LitSurface& surface : kLitSurfaces) {
    const auto colour = colourOf(pixels, surface);
    if (!colour) return Error{colour.error()};
    params.*surface.member = *colour;
  }
  return params;
}

}  // namespace kelpie::calibrate
