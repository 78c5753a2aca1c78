// SPDX-License-Identifier: Apache-2.0
// Where a camera of the broadcast stands and what it looks at, in metres in the axes of the red
// team's field. It is level, with the stage's opening angle.
#pragma once

#include <opencv2/core.hpp>
#include <optional>

namespace kelpie::broadcast {

constexpr double kOpening = 32.0;  // deg, from the picture's top to its bottom

struct View {
  cv::Vec3d eye{6.0, 2.7, 2.4};
  cv::Vec3d target{1.8, 2.7, 0.0};
};

// Where a point is seen in a picture of that size; nothing where it is behind the camera.
std::optional<cv::Point2d> project(const View& view, const cv::Vec3d& point, cv::Size size);

}  // namespace kelpie::broadcast
