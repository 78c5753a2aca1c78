// SPDX-License-Identifier: Apache-2.0
// Patches of one colour on the lattice: runs along rows, joined to blobs where runs of neighbouring
// rows touch, corners included (union-find). Fixed capacity: what does not fit is counted.
#pragma once

#include <cstdint>

#include "robot/core/FixedVector.h"
#include "robot/core/Geometry.h"
#include "robot/core/Percepts.h"
#include "vision/ColourClass.h"
#include "vision/Sampler.h"

namespace kelpie::vision {

struct Run {
  ColourClass colour = ColourClass::none;
  std::uint8_t row = 0;  // of the lattice
  std::uint8_t first = 0;
  std::uint8_t last = 0;
  std::uint16_t parent = 0;
  std::uint16_t blob = 0;
};

struct Blob {
  ColourClass colour = ColourClass::none;
  std::uint32_t samples = 0;
  PixelBox box;       // pixels covered: the lattice samples and half a step around them
  PixelPoint centre;  // mean of the samples
};

using RunBuffer = FixedVector<Run, 2048>;
using BlobBuffer = FixedVector<Blob, 384>;

// Blobs of orange, blue, yellow, pink and the two uniforms, in the order of their first run from
// the top. Returns the number of runs or blobs that did not fit.
std::uint32_t findBlobs(const Sampler& sampler, RunBuffer& runs, BlobBuffer& blobs);

}  // namespace kelpie::vision
