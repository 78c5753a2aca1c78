// SPDX-License-Identifier: Apache-2.0
#include "vision/colour/RingTable.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "robot/core/Maths.h"
#include "vision/colour/TableFile.h"

namespace kelpie::vision {
namespace {

// The coefficients printed in thesis 2006 section 2.3.2 for Y, Cr and Cb.
constexpr std::array<RingChannel, 3> k2006Channels = {
    {{-8.497e-08, 1.120e-05, -5.909e-06, -1.064e-03, -1.577e-03, 4.898e-02},
     {-1.561e-07, 1.081e-05, -3.532e-06, 1.331e-03, -1.145e-03, 1.363e-01},
     {-1.331e-07, 3.059e-05, -1.431e-05, 9.920e-04, -4.731e-04, 1.033e-01}}};
constexpr std::array<RingCentre, 3> k2005Centres = {
    {{110, kMiddleRow}, {105, kMiddleRow}, {97, kMiddleRow}}};

std::uint8_t asByte(double value) {
  constexpr double kMaxByte = kByteValues - 1.0;
  return static_cast<std::uint8_t>(maths::clamp(std::floor(value + 0.5), 0.0, kMaxByte));
}

void fill(const RingChannel& model, const ChannelShift& shift, RingTable::Channel& channel) {
  for (std::size_t d = 0; d < kRingDistances; ++d) {
    for (std::size_t v = 0; v < kByteValues; ++v) {
      const double own = ringCorrect(model, static_cast<double>(v), static_cast<double>(d));
      channel[kByteValues * d + v] = asByte(shift.gain * own + shift.offset);
    }
  }
}

bool allowed(RingCentre c) {
  return std::abs(c.column - kMiddleColumn) <= kMaxCentreOffset &&
         std::abs(c.row - kMiddleRow) <= kMaxCentreOffset;
}

// Beyond the distances of the printed fit (132) a cubic may turn; the last useful gain is kept.
constexpr double kMinGain = 0.25;

double gain(const RingChannel& c, double d) {
  return std::fmax(kMinGain, ((c.a1 * d + c.a2) * d + c.a3) * d + 1.0);
}
double offset(const RingChannel& c, double d) { return ((c.b1 * d + c.b2) * d + c.b3) * d; }

}  // namespace

RingModel ringModel2006() {
  RingModel model;
  model.channel = k2006Channels;
  return model;
}

RingModel ringModelNominal() {
  RingModel model = ringModel2006();
  model.centre = k2005Centres;
  return model;
}

double ringDistort(const RingChannel& c, double value, double distance) {
  return gain(c, distance) * value + offset(c, distance);
}

// Thesis 2006 equation 2.3; its printed a_Y in the denominator is the distance (checklist G02).
double ringCorrect(const RingChannel& c, double value, double distance) {
  return (value - offset(c, distance)) / gain(c, distance);
}

RingTable buildRingTable(const RingModel& model, const RobotShift& shift) {
  RingTable table;
  fill(model.channel[0], shift[0], table.y);
  fill(model.channel[1], shift[1], table.cr);
  fill(model.channel[2], shift[2], table.cb);
  table.centre = model.centre;
  return table;
}

RingTable shifted(const RingTable& table, const RobotShift& shift) {
  RingTable out = table;
  const std::array<RingTable::Channel*, 3> channels{&out.y, &out.cr, &out.cb};
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::uint8_t& value : *channels[c]) {
      value = asByte(shift[c].gain * value + shift[c].offset);
    }
  }
  return out;
}

Expected<RingTable> loadRingTable(const std::string& source) {
  if (source == "nominal") return buildRingTable(ringModelNominal());
  if (source == "none") return buildRingTable(RingModel{});
  if (source == "2006") return buildRingTable(ringModel2006());
  auto bytes = readBytes(source);
  if (!bytes)
    return Error{bytes.error() + " (ring correction: \"nominal\", \"none\", \"2006\" or a file)"};
  auto file = parseTableFile(source, *bytes, TableKind::ring, kRingFileBytes);
  if (!file) return Error{file.error()};
  RingTable table;
  const std::uint8_t* next = file->data.data();
  for (RingCentre& centre : table.centre) {
    centre.column = *next++;
    centre.row = *next++;
    if (!allowed(centre)) return Error{source + ": a ring centre far from the image's"};
  }
  for (auto* channel : {&table.y, &table.cr, &table.cb}) {
    std::copy_n(next, channel->size(), channel->data());
    next += channel->size();
  }
  return table;
}

Status saveRingTable(const RingTable& table, const std::string& path,
                     const std::string& provenance) {
  TableFile file{TableKind::ring, provenance, {}};
  for (const RingCentre& centre : table.centre) {
    file.data.push_back(static_cast<std::uint8_t>(centre.column));
    file.data.push_back(static_cast<std::uint8_t>(centre.row));
  }
  for (const auto* channel : {&table.y, &table.cr, &table.cb}) {
    file.data.insert(file.data.end(), channel->begin(), channel->end());
  }
  return writeTableFile(path, file);
}

RingDistances::RingDistances() {
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kColumns; ++x) {
      const double dx = x - kMiddle + 0.5;
      map[static_cast<std::size_t>(y * kColumns + x)] = asByte(maths::hypot(dx, y + 0.5));
    }
  }
}

}  // namespace kelpie::vision
