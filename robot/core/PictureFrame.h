// SPDX-License-Identifier: Apache-2.0
// A frame's input with a JPEG picture in place of the image: 3 KB instead of 100 KB. For people;
// the stages do not see it. What vision made of the image stands in the frame's output, from which
// a replay goes on (robot/agent/Replay.h).
#pragma once

#include <tuple>

#include "robot/core/FixedVector.h"
#include "robot/core/FrameInput.h"

namespace kelpie {

// A JPEG of a camera image at quality 75 takes 2 to 6 KB; pure noise would take 60.
using JpegBytes = FixedVector<std::uint8_t, 65536>;

// Its image is not part of the message.
struct PictureFrame : FrameInput {
  JpegBytes jpeg;  // Y, Cb, Cr at full resolution; empty when there is none

  static constexpr auto fields() {
    return withoutImage(FrameInput::fields(), field("jpeg", &PictureFrame::jpeg));
  }
};

}  // namespace kelpie
