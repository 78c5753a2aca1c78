// SPDX-License-Identifier: Apache-2.0
// Sizes along the horizon and square to it: the head rolls the image by up to 90 deg when it looks
// aside and down. Cheap looks at the carpet between the lattice's samples.
#pragma once

#include <algorithm>

#include "vision/SpanWalk.h"

namespace kelpie::vision {

// The first usable pixel with an even column and row.
constexpr int kCoarseLeft = 4;
constexpr int kCoarseTop = 4;

// Class of the even pixel at or just left and above of this one: while the head is level it is one
// of the lattice, whose class is known already.
inline bool inCoarse(int px, int py) {
  return px >= kCoarseLeft && px < kUsableRight && py >= kCoarseTop && py < kUsableBottom;
}
inline ColourClass coarseClass(const Sampler& sampler, int px, int py) {
  return sampler.classAt(px & ~1, py & ~1);
}

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
