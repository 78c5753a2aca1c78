// SPDX-License-Identifier: Apache-2.0
// Patches of one colour on the lattice: runs along its rows, joined to blobs where runs of
// neighbouring rows touch, corners included (union-find). Fixed capacity: what does not fit is
// counted.
#pragma once

#include <cstddef>
#include <cstdint>

#include "robot/core/FixedVector.h"
#include "robot/core/types/Geometry.h"
#include "robot/core/types/Percepts.h"
#include "vision/colour/ColourClass.h"
#include "vision/pixels/Lattice.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::vision {

struct Run {
  ColourClass colour = ColourClass::none;
  std::uint8_t row = 0;  // of the lattice
  std::uint8_t first = 0;
  std::uint8_t last = 0;
  std::uint8_t height = 1;  // rows it stands for
  std::uint16_t parent = 0;
  std::uint16_t blob = 0;
};

struct Blob {
  ColourClass colour = ColourClass::none;
  std::uint32_t samples = 0;
  LevelBox box;       // covered: the lattice samples and half a step around them
  LevelPoint middle;  // mean of the samples
  PixelPoint centre;  // their mean in the image
};

constexpr std::size_t kMaxRuns = 2048;
constexpr std::size_t kMaxBlobs = 384;
using RunBuffer = FixedVector<Run, kMaxRuns>;
using BlobBuffer = FixedVector<Blob, kMaxBlobs>;

struct BlobCounts {
  std::uint32_t samples = 0;  // pixels looked at
  std::uint32_t lost = 0;     // runs and blobs that did not fit
};

// Classifies the lattice. Blobs of orange, blue, yellow, pink and the two uniforms, in the order of
// their first run from the top.
BlobCounts findBlobs(const Sampler& sampler, const Lattice& lattice, RunBuffer& runs,
                     BlobBuffer& blobs);

}  // namespace kelpie::vision
