// SPDX-License-Identifier: Apache-2.0
// What the robot's camera showed and what vision found in it, in a frame of a canvas. Over an image
// that was kept of an earlier moment nothing is marked: it would be elsewhere. A match of percepts
// has no images: what each robot perceived stands on an empty ground.
#pragma once

#include "tools/match/Draw.h"
#include "tools/picture/Canvas.h"

namespace kelpie::match {

void drawCameraView(picture::Canvas& canvas, const picture::Frame& frame, const Moment& moment);

}  // namespace kelpie::match
