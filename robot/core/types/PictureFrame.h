// SPDX-License-Identifier: Apache-2.0
// A frame's input with a JPEG picture in place of the image: 2 to 4 KB instead of 100 KB. For
// people; the stages do not see it. What vision made of the image stands in the frame's output,
// from which a replay goes on (robot/agent/log/Replay.h).
#pragma once

#include <tuple>

#include "robot/core/FixedVector.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie {

// An image of a match takes 2 to 4 KB; one of pure noise would take 30.
using JpegBytes = FixedVector<std::uint8_t, 65536>;

// Its image is not part of the message.
struct PictureFrame : FrameInput {
  JpegBytes jpeg;  // 208 x 160 pixels; empty when there is none

  template <int = 0>
  static constexpr auto fields() {
    return withoutImage(FrameInput::fields(), field("jpeg", &PictureFrame::jpeg));
  }
};

}  // namespace kelpie
