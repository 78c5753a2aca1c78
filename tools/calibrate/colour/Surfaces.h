// SPDX-License-Identifier: Apache-2.0
// What carpet, lines and landmarks look like among labelled pixels, by which vision then tells
// another light (vision/light/LightParams.h). Medians, since a box of labels holds some pixels of
// what is beside it. Fails where a surface has few labels or hardly a colour, and where `white` or
// `green` was labelled on something else than lines and carpet.
#pragma once

#include <array>

#include "robot/core/Expected.h"
#include "tools/calibrate/colour/Labels.h"
#include "vision/light/LightParams.h"

namespace kelpie::calibrate {

struct LitSurface {
  const char* name;  // of the parameter
  vision::SurfaceColour vision::LightParams::*member;
  vision::ColourClass colour;
};
constexpr std::array<LitSurface, 5> kLitSurfaces = {
    {{"carpet", &vision::LightParams::carpet, vision::ColourClass::green},
     {"line", &vision::LightParams::line, vision::ColourClass::white},
     {"blue", &vision::LightParams::blue, vision::ColourClass::blue},
     {"yellow", &vision::LightParams::yellow, vision::ColourClass::yellow},
     {"pink", &vision::LightParams::pink, vision::ColourClass::pink}}};

// An error names the class that is lacking.
Expected<vision::LightParams> surfacesOf(const LabelledPixels& pixels);

}  // namespace kelpie::calibrate
