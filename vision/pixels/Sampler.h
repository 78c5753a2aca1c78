// SPDX-License-Identifier: Apache-2.0
// One image as the finders read it: ring-corrected values and colour classes. A pixel is corrected
// and classified at most once a frame; its class is kept in VisionState.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "robot/core/types/Geometry.h"
#include "robot/core/types/Image.h"
#include "vision/pixels/ClassMemory.h"
#include "vision/pixels/FixedPoint.h"
#include "vision/pixels/PixelTables.h"

namespace kelpie::vision {

// The ERS-7's outermost three pixels are unusable (facts-2005 section 4.1).
constexpr int kRim = 3;
constexpr int kUsableLeft = kRim;
constexpr int kUsableTop = kRim;
constexpr int kUsableRight = kImageWidth - kRim;  // first column beyond
constexpr int kUsableBottom = kImageHeight - kRim;

class Sampler {
 public:
  Sampler(const Image& image, const PixelTables& tables, ClassMemory& classes)
      : image_(image), tables_(tables), classes_(classes) {
    const auto& centre = tables.ring.centre;
    for (std::size_t channel = 0; channel < centre.size(); ++channel) {
      for (int py = 0; py < kImageHeight; ++py)
        rows_[channel][static_cast<std::size_t>(py)] = tables.distances.row(py, centre[channel]);
    }
    oneCentre_ = rows_[0] == rows_[1] && rows_[0] == rows_[2];
  }

  // Unsigned, so that one comparison tells both ends.
  static bool usable(int px, int py) {
    constexpr auto kColumns = static_cast<unsigned>(kUsableRight - kUsableLeft);
    constexpr auto kRows = static_cast<unsigned>(kUsableBottom - kUsableTop);
    return static_cast<unsigned>(px) - kUsableLeft < kColumns &&
           static_cast<unsigned>(py) - kUsableTop < kRows;
  }
  // Cutting off is rounding down where a pixel is usable, and -0.9 is unusable as well as 0.
  static bool usable(PixelPoint p) { return usable(static_cast<int>(p.x), static_cast<int>(p.y)); }
  // The floor, without the library's.
  static int pixelOf(double coordinate) {
    const int towardsZero = static_cast<int>(coordinate);
    return towardsZero - (coordinate < towardsZero ? 1 : 0);
  }

  Yuv corrected(int px, int py) const {
    const auto row = static_cast<std::size_t>(py);
    const std::uint8_t toY = rows_[0][row][px];
    if (oneCentre_) return tables_.ring(image_.pixel(px, py), {toY, toY, toY});
    return tables_.ring(image_.pixel(px, py), {toY, rows_[1][row][px], rows_[2][row][px]});
  }
  ColourClass classOf(Yuv corrected) const { return tables_.colour(corrected); }
  ColourClass classAt(int px, int py) const {
    const std::size_t at = Image::at(px, py);
    const unsigned known = classes_.at(at);
    return ClassMemory::knows(known) ? static_cast<ColourClass>(known) : classified(px, py);
  }
  // Of a place in the image.
  ColourClass classAt(PixelPoint p) const {
    return classAt(static_cast<int>(p.x), static_cast<int>(p.y));
  }
  // Classifies the samples of a lattice row that lie a step apart, positions in 1/65536 px. It
  // neither asks whether a pixel's class is known nor looks its rows up again while they stay the
  // same: the blobs' samples took a fifth more one by one.
  void classifyRow(std::int32_t x, std::int32_t y, std::int32_t stepX, std::int32_t stepY,
                   int count, std::uint8_t* out) const {
    // To look rows up outside the loop spares 9 of a sample's 47 instructions and takes some 40 for
    // each row of pixels: from a roll of 5 deg on fewer than six samples share it.
    constexpr std::int32_t kSteep = 0x2C00;
    if (std::abs(stepY) > kSteep) return classifyAcrossRows(x, y, stepX, stepY, count, out);
    classifyAlongRows(x, y, stepX, stepY, count, out);
  }
  // As measured: for differences between neighbours, which the ring correction hardly changes.
  Yuv raw(int px, int py) const { return image_.pixel(px, py); }
  std::uint8_t rawY(int px, int py) const { return image_.y[Image::at(px, py)]; }
  const Image::Plane& rawY() const { return image_.y; }

  // Forgets the last image.
  void reset() { classes_.forget(); }

 private:
  // Of a pixel that was not looked at. Apart, so that its callers, of whom nine in ten ask for a
  // known class, hold no more than that.
  ColourClass classified(int px, int py) const;
  // How many samples of a walk lie in the same row of pixels as the first, at least one.
  class SamplesInRow {
   public:
    explicit SamplesInRow(std::int32_t step)
        : down_(step >= 0), perStep_(step == 0 ? 0 : kMaxQuotient / magnitude(step)) {}
    int operator()(std::int32_t y) const {
      constexpr std::int32_t kLast = 0xFFFF;
      if (perStep_ == 0) return kImageWidth;
      const auto rest = static_cast<std::uint32_t>(down_ ? kLast - (y & kLast) : y & kLast);
      // The quotient by the step or one less, which leaves a sample for a run of its own: a
      // division for each row of pixels takes as long as seven samples.
      return 1 + static_cast<int>((std::uint64_t{rest} * perStep_) >> kQuotientBits);
    }

   private:
    static constexpr int kQuotientBits = 32;
    static constexpr std::uint32_t kMaxQuotient = 0xFFFFFFFFU;  // 2^32 - 1
    static std::uint32_t magnitude(std::int32_t step) {
      return static_cast<std::uint32_t>(std::abs(step));
    }
    bool down_;
    std::uint32_t perStep_;  // of 2^32
  };

  // Bases are held in locals: for all that the compiler knows, storing a class may change what the
  // members refer to.
  void classifyAlongRows(std::int32_t from, std::int32_t y, std::int32_t step, std::int32_t stepY,
                         int count, std::uint8_t* out) const {
    const Image& image = image_;
    const PixelTables& tables = tables_;
    std::uint8_t* const classes = classes_.cells();
    const unsigned number = classes_.image();
    const SamplesInRow samplesInRow(stepY);
    // As wide as an index, so that none is made wider for each sample; it wraps where steps are
    // negative.
    auto x = static_cast<std::size_t>(from);
    const auto stepX = static_cast<std::size_t>(step);
    for (const std::uint8_t* const last = out + count; out < last;) {
      const int here = std::min(static_cast<int>(last - out), samplesInRow(y));
      const auto row = static_cast<std::size_t>(y >> kLatticeBits);
      y += here * stepY;
      const std::size_t start = row * kImageWidth;
      const std::uint8_t* const toY = rows_[0][row];
      const std::uint8_t* const toCr = rows_[1][row];
      const std::uint8_t* const toCb = rows_[2][row];
      for (const std::uint8_t* const end = out + here; out != end; ++out, x += stepX) {
        const std::size_t px = x >> kLatticeBits;
        const std::size_t at = start + px;
        const Yuv raw{image.y[at], image.cr[at], image.cb[at]};
        const Yuv corrected = tables.ring(raw, {toY[px], toCr[px], toCb[px]});
        const auto colour = static_cast<unsigned>(tables.colour(corrected));
        *out = static_cast<std::uint8_t>(colour);
        classes[at] = static_cast<std::uint8_t>(colour ^ number);
      }
    }
  }

  void classifyAcrossRows(std::int32_t x, std::int32_t y, std::int32_t stepX, std::int32_t stepY,
                          int count, std::uint8_t* out) const {
    const Image& image = image_;
    const PixelTables& tables = tables_;
    std::uint8_t* const classes = classes_.cells();
    const unsigned number = classes_.image();
    std::array<const std::uint8_t*, 3> to{};
    std::size_t start = 0;
    int row = -1;
    for (const std::uint8_t* const end = out + count; out != end; ++out, x += stepX, y += stepY) {
      const int py = y >> kLatticeBits;
      if (py != row) {
        row = py;
        start = Image::at(0, py);
        for (std::size_t c = 0; c < 3; ++c) to[c] = rows_[c][static_cast<std::size_t>(py)];
      }
      const auto px = static_cast<std::size_t>(x >> kLatticeBits);
      const std::size_t at = start + px;
      const Yuv raw{image.y[at], image.cr[at], image.cb[at]};
      const Yuv corrected = tables.ring(raw, {to[0][px], to[1][px], to[2][px]});
      const auto colour = static_cast<unsigned>(tables.colour(corrected));
      *out = static_cast<std::uint8_t>(colour);
      classes[at] = static_cast<std::uint8_t>(colour ^ number);
    }
  }

  const Image& image_;
  const PixelTables& tables_;
  ClassMemory& classes_;
  // The distances of every row's pixels from each channel's centre: looking the row up for each
  // pixel cost 60 instructions of its 110. Here, not beside the tables, from where 30,000 more of
  // an image's instructions fetched them.
  std::array<std::array<const std::uint8_t*, kImageHeight>, 3> rows_{};
  bool oneCentre_ = false;
};

// The first usable pixel with an even column and row.
constexpr int kCoarseLeft = 4;
constexpr int kCoarseTop = 4;

// Class of the even pixel at or just left and above of this one: while the head is level it is one
// of the lattice, whose class is known already.
inline bool inCoarse(int px, int py) {
  return static_cast<unsigned>(px) - kCoarseLeft < kUsableRight - kCoarseLeft + 0U &&
         static_cast<unsigned>(py) - kCoarseTop < kUsableBottom - kCoarseTop + 0U;
}
inline ColourClass coarseClass(const Sampler& sampler, int px, int py) {
  return sampler.classAt(px & ~1, py & ~1);
}

}  // namespace kelpie::vision
