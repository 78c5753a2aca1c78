// SPDX-License-Identifier: Apache-2.0
// The size of a coloured patch along the horizon and square to it: the head rolls the image by up
// to 90 deg when it looks to the side and down.
#pragma once

#include <algorithm>

#include "vision/pixels/SpanWalk.h"

namespace kelpie::vision {

// Pixels from a patch's centre to its edges, 1 at least.
struct Extent {
  double left = 1.0;
  double right = 1.0;
  double upper = 1.0;
  double lower = 1.0;

  double width() const { return left + right; }
  double height() const { return upper + lower; }
};

inline Extent extentOf(const Sampler& sampler, const HorizonFrame& frame, PixelPoint centre,
                       ColourClass colour) {
  constexpr int kHoles = 2;  // px of another class inside a patch
  const auto edge = [&](ImageDirection direction) {
    return std::max(1.0, walkToEdge(sampler, {centre, direction, colour, kHoles}).length);
  };
  return {edge(-frame.right()), edge(frame.right()), edge(frame.up()), edge(-frame.up())};
}

}  // namespace kelpie::vision
