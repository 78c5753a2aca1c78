// SPDX-License-Identifier: Apache-2.0
// A frame's input as a log holds it: with the image, with a class plane from which an image is made
// again (robot/core/types/PlaneFrame.h, vision/pixels/PlaneImage.h), or with a picture for people
// only (robot/core/types/PictureFrame.h).
#pragma once

#include <string>

#include "robot/agent/log/LoggedTypes.h"
#include "robot/core/log/LogReader.h"
#include "robot/core/log/LogTopics.h"
#include "robot/core/types/PlaneFrame.h"

namespace kelpie::agent {

bool isFrameInput(const std::string& topic);
// An error names topic and byte. Of a picture frame the image is left as it was.
Status decodeFrameInput(const LogMessage& message, FrameInput& input);

}  // namespace kelpie::agent
