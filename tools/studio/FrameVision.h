// SPDX-License-Identifier: Apache-2.0
// What the robot's vision makes of one frame of a log again: the class of every pixel, as a
// picture, and the blobs that it refused, each with its box and why. Only of frames whose image,
// class plane or picture the log holds.
#pragma once

#include <string>

#include "robot/core/Expected.h"
#include "robot/core/Time.h"

namespace kelpie::studio {

// Writes the picture as a PNG file to `out`. `time` is that of the frame's message in the log.
Status drawClasses(const std::string& log, TimeUs time, const std::string& out);
// JSON: [{"kind": "orange", "reason": "ball few edges", "box": [left, top, right, bottom]}], px.
Expected<std::string> refusedJson(const std::string& log, TimeUs time);

}  // namespace kelpie::studio
