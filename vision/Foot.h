// SPDX-License-Identifier: Apache-2.0
// Where a thing stands on the carpet: from a point of it down the image to the green. Wrong where a
// white line begins at its foot, and where something else stands right before it.
#pragma once

#include <optional>

#include "robot/core/types/Geometry.h"
#include "vision/Scene.h"

namespace kelpie::vision {

enum class FootEnd : std::uint8_t { carpet, imageBorder, hidden };

constexpr double kNoDistance = 1e6;

struct Foot {
  FootEnd end = FootEnd::hidden;
  PixelPoint pixel;  // on the border between the thing and the carpet, or where the image ends
  double distance = kNoDistance;  // cm along the ground from the camera to what is seen there
};

struct FootSearch {
  PixelPoint from;     // in the thing
  double first = 0.0;  // px to the right of it, of the first of the columns and of the last
  double last = 0.0;
  int columns = 1;
  ColourClass own = ColourClass::none;  // the thing's colour
  double nearer = kNoDistance;          // cm; a foot that is no nearer is not placed to the pixel
};

// The nearest of the feet of several columns. A column in which another thing's orange, yellow,
// pink or blue comes before the foot has no foot.
Foot nearestFoot(const Scene& scene, const FootSearch& search);

// Pixels of carpet above the level of a foot, beside the thing that stands there: `beside` px from
// the foot and farther, on both sides together, because the carpet's end may be askew. What seems
// to stand on the carpet's very end is beyond it. kUnknownBehind where the image shows too little.
constexpr double kUnknownBehind = -100.0;
double carpetBehind(const Scene& scene, PixelPoint foot, double beside);

// Along the ground from the camera to what a pixel sees there; nothing above the horizon.
std::optional<double> groundDistance(const CameraPose& camera, PixelPoint pixel);

// Height above the ground of what is seen in `pixel` at a distance along the ground.
double heightAt(const CameraPose& camera, PixelPoint pixel, double distance);

}  // namespace kelpie::vision
