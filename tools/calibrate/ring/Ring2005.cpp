// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/ring/Ring2005.h"

#include <algorithm>
#include <cstdlib>

#include "tools/calibrate/ring/Sheets.h"
#include "vision/colour/TableFile.h"

namespace kelpie::calibrate {
namespace {

constexpr int kMapColumns = 112;
constexpr std::array<const char*, 3> kFiles = {"ring2005_y_256x137.bin", "ring2005_u_256x133.bin",
                                               "ring2005_v_256x137.bin"};
constexpr std::array<std::size_t, 3> kRadii = {137, 133, 137};

Expected<std::vector<std::uint8_t>> readSized(const std::string& path, std::size_t size) {
  auto bytes = vision::readBytes(path);
  if (!bytes) return Error{bytes.error()};
  if (bytes->size() != size)
    return Error{path + ": " + std::to_string(bytes->size()) + " bytes, expected " +
                 std::to_string(size)};
  return *bytes;
}

}  // namespace

std::uint8_t Ring2005::corrected(int px, int py, Yuv raw, std::size_t channel) const {
  const int lateral = std::min(std::abs(px - kRing2005Centres[channel]), kMapColumns - 1);
  const std::size_t far = radius[static_cast<std::size_t>(py * kMapColumns + lateral)];
  const std::size_t column = std::min(far, radii[channel] - 1);
  return table[channel][radii[channel] * channelOf(raw, channel) + column];
}

Expected<Ring2005> loadRing2005(const std::string& folder) {
  Ring2005 ring;
  auto map = readSized(folder + "/ring2005_radius_160x112.bin", std::size_t{160} * kMapColumns);
  if (!map) return Error{map.error()};
  ring.radius = std::move(*map);
  ring.radii = kRadii;
  for (std::size_t c = 0; c < 3; ++c) {
    auto table = readSized(folder + "/" + kFiles[c], 256 * kRadii[c]);
    if (!table) return Error{table.error()};
    ring.table[c] = std::move(*table);
  }
  return ring;
}

}  // namespace kelpie::calibrate
