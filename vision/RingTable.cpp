// SPDX-License-Identifier: Apache-2.0
#include "vision/RingTable.h"

#include <algorithm>
#include <cmath>

#include "robot/core/Maths.h"
#include "vision/TableFile.h"

namespace kelpie::vision {
namespace {

std::uint8_t asByte(double value) {
  return static_cast<std::uint8_t>(maths::clamp(std::floor(value + 0.5), 0.0, 255.0));
}

void fill(const RingChannel& model, RingTable::Channel& channel) {
  for (std::size_t d = 0; d < kRingDistances; ++d) {
    for (std::size_t v = 0; v < 256; ++v) {
      channel[256 * d + v] =
          asByte(ringCorrect(model, static_cast<double>(v), static_cast<double>(d)));
    }
  }
}

double gain(const RingChannel& c, double d) { return ((c.a1 * d + c.a2) * d + c.a3) * d + 1.0; }
double offset(const RingChannel& c, double d) { return ((c.b1 * d + c.b2) * d + c.b3) * d; }

}  // namespace

RingModel ringModel2006() {
  RingModel model;
  model.channel[0] = {-8.497e-08, 1.120e-05, -5.909e-06, -1.064e-03, -1.577e-03, 4.898e-02};
  model.channel[1] = {-1.561e-07, 1.081e-05, -3.532e-06, 1.331e-03, -1.145e-03, 1.363e-01};
  model.channel[2] = {-1.331e-07, 3.059e-05, -1.431e-05, 9.920e-04, -4.731e-04, 1.033e-01};
  return model;
}

double ringDistort(const RingChannel& c, double value, double distance) {
  return gain(c, distance) * value + offset(c, distance);
}

// Equation 2.3; its printed a_Y in the denominator is the distance (checklist G02).
double ringCorrect(const RingChannel& c, double value, double distance) {
  return (value - offset(c, distance)) / gain(c, distance);
}

RingTable buildRingTable(const RingModel& model) {
  RingTable table;
  fill(model.channel[0], table.y);
  fill(model.channel[1], table.cr);
  fill(model.channel[2], table.cb);
  return table;
}

Expected<RingTable> loadRingTable(const std::string& source) {
  if (source == "none") return buildRingTable(RingModel{});
  if (source == "2006") return buildRingTable(ringModel2006());
  auto bytes = readBytes(source);
  if (!bytes) return Error{bytes.error() + " (ring correction: \"none\", \"2006\" or a file)"};
  RingTable table;
  constexpr std::size_t kChannel = kRingDistances * 256;
  auto file = parseTableFile(source, *bytes, TableKind::ring, 3 * kChannel);
  if (!file) return Error{file.error()};
  std::copy_n(file->data.data(), kChannel, table.y.data());
  std::copy_n(file->data.data() + kChannel, kChannel, table.cr.data());
  std::copy_n(file->data.data() + 2 * kChannel, kChannel, table.cb.data());
  return table;
}

Status saveRingTable(const RingTable& table, const std::string& path,
                     const std::string& provenance) {
  TableFile file{TableKind::ring, provenance, {}};
  for (const auto* channel : {&table.y, &table.cr, &table.cb}) {
    file.data.insert(file.data.end(), channel->begin(), channel->end());
  }
  return writeTableFile(path, file);
}

RingDistances::RingDistances() {
  for (std::size_t y = 0; y < kHalfHeight; ++y) {
    for (std::size_t x = 0; x < kHalfWidth; ++x) {
      const double dx = static_cast<double>(x) + 0.5;
      const double dy = static_cast<double>(y) + 0.5;
      quarter[y * kHalfWidth + x] = asByte(maths::hypot(dx, dy));
    }
  }
}

}  // namespace kelpie::vision
