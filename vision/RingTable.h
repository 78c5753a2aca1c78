// SPDX-License-Identifier: Apache-2.0
// Ring correction: the ERS-7 darkens and discolours its image towards the corners, equally at equal
// distance from the middle. One byte for each channel, distance 0..132 px and measured value gives
// the value that the middle of the image would show (thesis 2006 section 2.3; 100 KB).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "robot/core/Expected.h"
#include "robot/core/Fields.h"
#include "robot/core/Image.h"

namespace kelpie::vision {

constexpr std::size_t kRingDistances = 133;

// Thesis 2006 equation 2.2: Yd = (a1 Yc + b1) d^3 + (a2 Yc + b2) d^2 + (a3 Yc + b3) d + Yc.
struct RingChannel {
  double a1 = 0.0;
  double b1 = 0.0;
  double a2 = 0.0;
  double b2 = 0.0;
  double a3 = 0.0;
  double b3 = 0.0;
};

struct RingModel {
  std::array<RingChannel, 3> channel{};  // Y, Cr, Cb
};

// The coefficients printed in thesis 2006 section 2.3.2 (checklist A-2.3.2.6).
RingModel ringModel2006();
double ringDistort(const RingChannel& c, double value, double distance);
double ringCorrect(const RingChannel& c, double value, double distance);  // its exact inverse

struct RingTable {
  using Channel = std::array<std::uint8_t, kRingDistances * 256>;
  Channel y{};  // [256 * distance + value]
  Channel cr{};
  Channel cb{};

  Yuv operator()(Yuv raw, std::size_t distance) const {
    const std::size_t row = distance * 256;
    return {y[row + raw.y], cr[row + raw.cr], cb[row + raw.cb]};
  }
  static constexpr auto fields() {
    return fieldList(field("y", &RingTable::y), field("cr", &RingTable::cr),
                     field("cb", &RingTable::cb));
  }
};

// The inverse of the model, rounded and clamped to a byte (about 19 % of the entries, E3).
RingTable buildRingTable(const RingModel& model);
// "none" changes nothing, "2006" is the published polynomial, anything else a file of our format.
Expected<RingTable> loadRingTable(const std::string& source);
Status saveRingTable(const RingTable& table, const std::string& path,
                     const std::string& provenance);

// Distance of every pixel's centre from the image centre, rounded; one quarter, the rest mirrors.
struct RingDistances {
  static constexpr std::size_t kHalfWidth = kImageWidth / 2;
  static constexpr std::size_t kHalfHeight = kImageHeight / 2;
  std::array<std::uint8_t, kHalfWidth * kHalfHeight> quarter{};

  RingDistances();
  const std::uint8_t* row(int py) const {
    const int half = py < kImageHeight / 2 ? kImageHeight / 2 - 1 - py : py - kImageHeight / 2;
    return quarter.data() + static_cast<std::size_t>(half) * kHalfWidth;
  }
  static std::size_t column(int px) {
    return static_cast<std::size_t>(px < kImageWidth / 2 ? kImageWidth / 2 - 1 - px
                                                         : px - kImageWidth / 2);
  }
  std::size_t operator()(int px, int py) const { return row(py)[column(px)]; }
};

}  // namespace kelpie::vision
