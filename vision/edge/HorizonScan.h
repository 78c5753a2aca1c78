// SPDX-License-Identifier: Apache-2.0
// Scan lines: straight walks through the image square to the horizon, every 4 px along it, from
// just above the horizon down to the end of the usable image. The head tilts and pans, so the image
// is rolled and the lines lean with it. They are columns of the lattice, whose classes are known.
// No lines when the field cannot be seen: the whole image is above the horizon.
#pragma once

#include "robot/core/ScratchVector.h"
#include "robot/core/types/Percepts.h"
#include "vision/edge/FieldEdgeParams.h"
#include "vision/pixels/HorizonFrame.h"
#include "vision/pixels/Lattice.h"
#include "vision/pixels/PixelWalk.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::vision {

struct ScanLine {
  PixelPoint top;  // the end at the horizon, on the lattice; every step below is a usable pixel
  ImageDirection down{0.0, 1.0};
  int steps = 0;        // of one pixel, 0..steps - 1
  bool cutTop = false;  // the image ends before the line has reached the horizon

  PixelPoint at(double step) const { return moved(top, down, step); }
};

constexpr int kHorizonScanSpacing = 4;  // px along the horizon
// The image's diagonal is 262 px.
constexpr std::size_t kMaxScanLines = 68;
using ScanLines = ScratchVector<ScanLine, kMaxScanLines>;

// From left to right along the horizon.
ScanLines horizonScan(const Lattice& lattice, const HorizonScanParams& params);

// A scan line's classes at whole steps: a thousand are asked for in an image.
class LineClasses {
 public:
  LineClasses(const Sampler& sampler, const ScanLine& line)
      : sampler_(sampler), walk_(line.top, line.down) {}

  ColourClass at(int step) const { return sampler_.classAt(walk_.x(step), walk_.y(step)); }
  // Of the step itself or the one after it that is a sample of the lattice: next to none is
  // classified again.
  ColourClass nextTo(int step) const { return at((step + 1) & ~1); }

 private:
  const Sampler& sampler_;
  PixelWalk walk_;
};

}  // namespace kelpie::vision
