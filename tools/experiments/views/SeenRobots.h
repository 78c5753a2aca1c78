// SPDX-License-Identifier: Apache-2.0
// Which robots of a view its camera really shows, and how much of each: counted in pictures without
// artefacts in which every robot has a colour of its own. Truth: to compare with what vision says,
// never for vision.
#pragma once

#include <vector>

#include "tools/experiments/views/View.h"

namespace kelpie::experiments {

struct SeenRobot {
  TeamColour team = TeamColour::red;
  double distance = 0.0;  // cm from the seeing robot's origin to the body's middle
  Angle heading;
  Angle turned;              // its heading as seen: 0 away from the camera, 90 deg to the left
  double share = 0.0;        // of the pixels it would have in full view, those that really show
  double patchPixels = 0.0;  // of its uniform
  PixelBox box;              // of what shows
};

// Robots with at least one pixel in the usable image, in the order of view.robots.
std::vector<SeenRobot> seenRobots(const View& view);

}  // namespace kelpie::experiments
