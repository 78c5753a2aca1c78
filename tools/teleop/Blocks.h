// SPDX-License-Identifier: Apache-2.0
// A camera image as coloured text: each character shows two pixels, one above the other, by the
// colours of its foreground and background. Wants a terminal of 24-bit colours and UTF-8; what it
// can do nobody asks it, so that another one shows rubbish.
#pragma once

#include <string>
#include <vector>

#include "robot/core/types/Image.h"

namespace kelpie::teleop {

struct TextSize {
  int columns = 0;
  int rows = 0;
};

// The largest picture of the image's shape that fits, characters being twice as high as wide; of
// size 0 where it would be too small to see anything.
TextSize pictureSize(TextSize room);

// One string a row, each ending in plain colours.
std::vector<std::string> blocksOf(const Image& image, TextSize size);

}  // namespace kelpie::teleop
