// SPDX-License-Identifier: Apache-2.0
// The ring correction that a real robot ran in 2005, for comparison (facts-2005 section 3): one map
// of radii by row and |column - centre|, and per channel a table of 256 values by radius. Reads
// ../shared/data/camera; says which file is absent or of another size.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/types/Image.h"

namespace kelpie::calibrate {

struct Ring2005 {
  std::vector<std::uint8_t> radius;                // [112 * row + |column - centre|]
  std::array<std::vector<std::uint8_t>, 3> table;  // [radii * value + radius]
  std::array<std::size_t, 3> radii{};              // Y 137, Cr 133, Cb 137

  std::uint8_t corrected(int px, int py, Yuv raw, std::size_t channel) const;
};

constexpr std::array<int, 3> kRing2005Centres = {110, 105, 97};  // columns

Expected<Ring2005> loadRing2005(const std::string& folder);

}  // namespace kelpie::calibrate
