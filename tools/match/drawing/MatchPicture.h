// SPDX-License-Identifier: Apache-2.0
// One picture of a whole match, for who comes new: title, the field with the paths of robot and
// ball, and the six moments that matter with what the robot saw, did and why.
#pragma once

#include <functional>
#include <opencv2/core.hpp>

#include "robot/core/Expected.h"
#include "tools/match/Match.h"

namespace kelpie::match {

// Goes through the log twice; `progress` hears how many of all frames are done. An error only where
// nothing can be drawn, for want of memory or of a font.
Expected<cv::Mat> drawMatch(const Match& match,
                            const std::function<void(std::size_t, std::size_t)>& progress);

}  // namespace kelpie::match
