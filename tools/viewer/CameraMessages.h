// SPDX-License-Identifier: Apache-2.0
// A robot's camera: its image, its lens, and what vision found in the image.
#pragma once

#include <string>
#include <vector>

#include "foxglove/Camera.pb.h"
#include "robot/core/types/FrameOutput.h"

namespace kelpie::viewer {

foxglove::CompressedImage cameraImage(TimeUs time, const std::string& robot,
                                      const std::vector<std::uint8_t>& jpeg);

// An edge term becomes the first three radial coefficients of the model that viewers know; what is
// left out is of the ninth power of the tangent.
foxglove::CameraCalibration calibrationOf(TimeUs time, const std::string& robot, const Lens& lens);

// Ball, landmarks, gaps, robots, pink patches, borders of the carpet, line points.
foxglove::ImageAnnotations annotationsOf(TimeUs time, const Percepts& percepts);

}  // namespace kelpie::viewer
