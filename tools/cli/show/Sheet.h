// SPDX-License-Identifier: Apache-2.0
// One picture of one frame for people: the image with what was found in it, every pixel's class,
// the pixels that vision looked at with its blobs, and the numbers beside them.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "robot/core/types/FrameInput.h"
#include "robot/core/types/FrameOutput.h"
#include "vision/VisionState.h"

namespace kelpie::cli {

struct SheetIn {
  std::string title;
  const FrameInput& input;
  const FrameOutput& output;          // body and percepts are read
  const vision::VisionState& vision;  // as the step on this image left it
  std::vector<std::string> why = {};  // what the log tells of the frame's decision, a line each
};

cv::Mat drawSheet(const SheetIn& in);

// The words of the sheet, apart so that they can be tested: cells of a table, tab between them.
struct SheetText {
  std::vector<std::string> frame;     // camera, horizon, counts
  std::vector<std::string> objects;   // name, distance, its sd, heading, its sd, remark
  std::vector<std::string> refusals;  // reason, how often; the commonest first
};
SheetText sheetText(const SheetIn& in);

}  // namespace kelpie::cli
