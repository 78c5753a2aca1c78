// SPDX-License-Identifier: Apache-2.0
// Ring correction: the ERS-7 darkens and discolours its image towards the corners, equally at equal
// distance from a centre that each channel has for itself. One byte for each channel, distance and
// measured value gives the value that the middle of the image would show (thesis 2006 section 2.3;
// 112 KB). A robot's shift to the base robot's colours is folded in, so it costs nothing to apply.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "robot/core/Expected.h"
#include "robot/core/fields/Fields.h"
#include "robot/core/types/Image.h"

namespace kelpie::vision {

// A real robot's centres lay 6 columns right (Y), 1 right (Cr) and 7 left (Cb) of the image's
// (facts-2005 section 3); twice that is allowed, in columns and in rows.
constexpr int kMaxCentreOffset = 12;
constexpr int kMiddleColumn = kImageWidth / 2;
constexpr int kMiddleRow = kImageHeight / 2;
constexpr std::size_t kRingDistances = 149;  // hypot(104 + 12, 80 + 12) = 148.1
constexpr unsigned kByteValues = 256;        // of a channel

// Thesis 2006 equation 2.2: Yd = (a1 Yc + b1) d^3 + (a2 Yc + b2) d^2 + (a3 Yc + b3) d + Yc.
struct RingChannel {
  double a1 = 0.0;
  double b1 = 0.0;
  double a2 = 0.0;
  double b2 = 0.0;
  double a3 = 0.0;
  double b3 = 0.0;
};

// The corner between four pixels from which a channel's distances count; whole, because half a
// pixel changes no value by more than half a grey level.
struct RingCentre {
  std::int32_t column = kMiddleColumn;
  std::int32_t row = kMiddleRow;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("column", &RingCentre::column, "px", kMiddleColumn - kMaxCentreOffset,
                           kMiddleColumn + kMaxCentreOffset),
                     field("row", &RingCentre::row, "px", kMiddleRow - kMaxCentreOffset,
                           kMiddleRow + kMaxCentreOffset));
  }
};

struct RingModel {
  std::array<RingChannel, 3> channel{};  // Y, Cr, Cb
  std::array<RingCentre, 3> centre{};
};

// From a robot's colours to the base robot's: out = gain * in + offset (facts-2005 section 3).
struct ChannelShift {
  double gain = 1.0;
  double offset = 0.0;
};
using RobotShift = std::array<ChannelShift, 3>;  // Y, Cr, Cb

// The coefficients printed in thesis 2006 section 2.3.2 (checklist A-2.3.2.6).
RingModel ringModel2006();
// Its coefficients about the centres of the correction of 2005, columns 110, 105 and 97 of the
// middle row (facts-2005 section 3), which served every robot. For one whose own centres nobody
// measured.
RingModel ringModelNominal();
double ringDistort(const RingChannel& c, double value, double distance);
double ringCorrect(const RingChannel& c, double value, double distance);  // its exact inverse

// Where a pixel lies: its distance from each channel's centre.
struct RingPlace {
  std::uint8_t y = 0;
  std::uint8_t cr = 0;
  std::uint8_t cb = 0;
};

struct RingTable {
  using Channel = std::array<std::uint8_t, kRingDistances * kByteValues>;
  Channel y{};  // [kByteValues * distance + value]
  Channel cr{};
  Channel cb{};
  std::array<RingCentre, 3> centre{};

  Yuv operator()(Yuv raw, RingPlace at) const {
    return {y[kByteValues * at.y + raw.y], cr[kByteValues * at.cr + raw.cr],
            cb[kByteValues * at.cb + raw.cb]};
  }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("y", &RingTable::y), field("cr", &RingTable::cr),
                     field("cb", &RingTable::cb), field("centre", &RingTable::centre));
  }
};

// The inverse of the model, then the shift, rounded once and clamped to a byte (up to distance 132
// about 19 % of the entries, checklist E3).
RingTable buildRingTable(const RingModel& model, const RobotShift& shift = {});
// Applies a shift to a table whose model is not at hand: rounded a second time.
RingTable shifted(const RingTable& table, const RobotShift& shift);

// "nominal" is ringModelNominal(), "none" changes nothing, "2006" is the published polynomial about
// the image's middle, anything else a file of our format.
Expected<RingTable> loadRingTable(const std::string& source);
Status saveRingTable(const RingTable& table, const std::string& path,
                     const std::string& provenance);
constexpr std::size_t kRingFileBytes = 6 + 3 * sizeof(RingTable::Channel);  // centres, tables

// Distance of every pixel's centre from any allowed ring centre, rounded; the lower half, the upper
// one mirrors (21 KB). A whole row, so that one channel costs one read and no arithmetic.
struct RingDistances {
  static constexpr int kColumns = kImageWidth + 2 * kMaxCentreOffset;
  static constexpr int kMiddle = kMiddleColumn + kMaxCentreOffset;
  static constexpr int kRows = kMiddleRow + kMaxCentreOffset;
  std::array<std::uint8_t, static_cast<std::size_t>(kColumns) * kRows> map{};

  RingDistances();
  // The distances of row `py`: [px].
  const std::uint8_t* row(int py, RingCentre centre) const {
    const int down = py < centre.row ? centre.row - 1 - py : py - centre.row;
    return map.data() + down * kColumns + (kMiddle - centre.column);
  }
  RingPlace operator()(int px, int py, const std::array<RingCentre, 3>& centre) const {
    return {row(py, centre[0])[px], row(py, centre[1])[px], row(py, centre[2])[px]};
  }
};

}  // namespace kelpie::vision
