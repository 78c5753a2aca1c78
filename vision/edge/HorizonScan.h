// SPDX-License-Identifier: Apache-2.0
// Scan lines: straight walks through the image square to the horizon, every 4 px along it, from
// just above the horizon down to the end of the usable image. The head tilts and pans, so the image
// is rolled and the lines lean with it. No lines when the field cannot be seen: the whole
// image is above the horizon.
#pragma once

#include "robot/core/FixedVector.h"
#include "robot/core/Percepts.h"
#include "vision/edge/FieldEdgeParams.h"
#include "vision/pixels/HorizonFrame.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::vision {

struct ScanLine {
  PixelPoint top;  // the end at the horizon; every step below is a usable pixel
  ImageDirection down{0.0, 1.0};
  int steps = 0;        // of one pixel, 0..steps - 1
  bool cutTop = false;  // the image ends before the line has reached the horizon

  PixelPoint at(double step) const { return moved(top, down, step); }
};

constexpr int kHorizonScanSpacing = 4;  // px along the horizon
// The image's diagonal is 262 px.
constexpr std::size_t kMaxScanLines = 68;
using ScanLines = FixedVector<ScanLine, kMaxScanLines>;

// From left to right along the horizon.
ScanLines horizonScan(const HorizonFrame& frame, const HorizonScanParams& params);

// Class at a step. A step is a usable pixel, so cutting off is rounding down.
inline ColourClass classAt(const Sampler& sampler, const ScanLine& line, int step) {
  const PixelPoint p = line.at(step);
  return sampler.classAt(static_cast<int>(p.x), static_cast<int>(p.y));
}
// Class of the lattice sample next to it: nothing is classified again. Usable pixels round up to
// 4..204 and 4..156, the lattice's own ends.
inline ColourClass latticeClass(const Sampler& sampler, const ScanLine& line, int step) {
  const PixelPoint p = line.at(step);
  const auto even = [](double c) { return (static_cast<int>(c) + 1) & ~1; };
  return sampler.classAt(even(p.x), even(p.y));
}

}  // namespace kelpie::vision
