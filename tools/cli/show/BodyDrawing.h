// SPDX-License-Identifier: Apache-2.0
// A physical robot and the ball as flat shapes, from its right side and from above: every part is
// the outline of its points and their thickness, the nearest drawn last. No perspective. What is
// outside the window is cut off.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "tools/sim/physics/Shapes.h"

namespace kelpie::cli {

// Both views, one below the other, ahead to the right. The window stays where the robot stood at
// `origin`: from 35 cm behind its neck base to 50 cm ahead.
cv::Mat drawBodies(const std::vector<sim::Shape>& shapes, const Pose2& origin, double pixelsPerCm);

}  // namespace kelpie::cli
