// SPDX-License-Identifier: Apache-2.0
// The rows of a recording as a function of time, for images that are older than their stamps: as
// the agent does with its ticks, joints, stance and way are taken from that much earlier, between
// two rows on the straight line from the one to the other. Before the first row all stands still.
#pragma once

#include <vector>

#include "tools/cli/log/Recording.h"

namespace kelpie::cli {

class RecordedTrack {
 public:
  explicit RecordedTrack(const std::vector<RecordedRow>& rows);

  // Everything of frame n but its image and what is believed of the camera; `lag` in seconds, 0 or
  // more. To be asked in the frames' order: each has the way since the one before.
  FrameInput input(std::size_t n, double lag);

 private:
  struct Way {
    double forward = 0.0;
    double left = 0.0;
    double turn = 0.0;  // rad, not wrapped
  };
  struct Place {
    std::size_t newer;  // the row at that time or the next
    double share;       // of the way to it from the one before
  };
  Place placeAt(std::size_t n, double time) const;
  Way wayAt(const Place& place) const;

  const std::vector<RecordedRow>& rows_;
  std::vector<Way> ways_;  // from the first row to each
  Way taken_;              // by the frames so far
};

}  // namespace kelpie::cli
