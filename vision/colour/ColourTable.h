// SPDX-License-Identifier: Apache-2.0
// The colour table: class of a ring-corrected pixel by five bits of Y and six each of Cr and Cb,
// two classes to a byte: 64 KB. It fits the robot's 256 KB second-level cache beside the ring table
// (100 KB); the 2005 table's 2 MB does not, and its cache misses were the largest cost (cross.md
// section 3). README.md compares the sizes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "robot/core/Expected.h"
#include "robot/core/fields/Fields.h"
#include "robot/core/types/Image.h"
#include "vision/colour/ColourClass.h"

namespace kelpie::vision {

constexpr double kNeutralChroma = 128.0;  // Cr and Cb of grey

struct ColourTable {
  static constexpr int kByteBits = 8;
  static constexpr unsigned kClassMask = 15U;  // four bits for each class
  static constexpr int kBitsY = 5;
  static constexpr int kBitsCr = 6;
  static constexpr int kBitsCb = 6;
  static constexpr std::size_t kCells = std::size_t{1} << (kBitsY + kBitsCr + kBitsCb);

  std::array<std::uint8_t, kCells / 2> cells{};  // even cell in the low half

  static std::size_t cellOf(Yuv p) {
    return (static_cast<std::size_t>(p.y >> (kByteBits - kBitsY)) << (kBitsCr + kBitsCb)) |
           (static_cast<std::size_t>(p.cr >> (kByteBits - kBitsCr)) << kBitsCb) |
           static_cast<std::size_t>(p.cb >> (kByteBits - kBitsCb));
  }
  // The same as at(cellOf(p)). The half of the byte is that of Cb's lowest bit in the cell's
  // number, where it stands already: every pixel passes here.
  ColourClass operator()(Yuv p) const {
    constexpr unsigned kHalfBit = kByteBits - kBitsCb;
    static_assert(kHalfBit == 2 && kBitsY + kBitsCr == 11);
    const unsigned cb = p.cb;
    const unsigned byte = ((p.y & 0xF8U) << 8U) | ((p.cr & 0xFCU) << 3U) | (cb >> 3U);
    return static_cast<ColourClass>((cells[byte] >> (cb & 4U)) & kClassMask);
  }
  ColourClass at(std::size_t cell) const {
    return static_cast<ColourClass>((cells[cell >> 1] >> ((cell & 1U) * 4U)) & kClassMask);
  }
  void set(std::size_t cell, ColourClass c) {
    const unsigned shift = (cell & 1U) * 4U;
    const unsigned kept = cells[cell >> 1] & (0xF0U >> shift);
    cells[cell >> 1] = static_cast<std::uint8_t>(kept | (static_cast<unsigned>(c) << shift));
  }
  // The colour in the middle of a cell.
  static Yuv centreOf(std::size_t cell);

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("cells", &ColourTable::cells));
  }
};

// Class ids of the 2005 release (facts-2005 section 3); 2 (an unused green), 11, 12 (drawing
// markers) and 127 mean nothing, the "maybe" bit is dropped.
ColourClass classOf2005(std::uint8_t id);

// Kelpie's own format, or the 2005 layout: 128^3 bytes by (Y/2, Cr/2, Cb/2) with the class ids of
// data/colour/classes.csv; its "maybe" bit 0x10 is dropped (the loose reading) and each cell here
// takes the commonest class of the 16 it covers.
Expected<ColourTable> loadColourTable(const std::string& path);
Status saveColourTable(const ColourTable& table, const std::string& path,
                       const std::string& provenance);

}  // namespace kelpie::vision
