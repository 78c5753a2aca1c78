// SPDX-License-Identifier: Apache-2.0
#include "vision/colour/ColourTable.h"

#include "vision/colour/TableFile.h"

namespace kelpie::vision {
namespace {

constexpr std::size_t k2005Size = std::size_t{1} << 21;
constexpr std::uint8_t kMaybeBit = 0x10;
constexpr int k2005Bits = 7;

std::uint8_t middle(std::size_t step, int bits) {
  const int spared = ColourTable::kByteBits - bits;
  return static_cast<std::uint8_t>((step << spared) + (std::size_t{1} << (spared - 1)));
}

std::size_t fineIndex(std::size_t y, std::size_t cr, std::size_t cb) {
  return (y << (2 * k2005Bits)) | (cr << k2005Bits) | cb;
}

// Commonest class of the fine cells below one of ours; on a tie the class with the lower number.
ColourClass majority(const Bytes& fine, std::size_t cell) {
  constexpr std::size_t kY = std::size_t{1} << (k2005Bits - ColourTable::kBitsY);
  constexpr std::size_t kC = std::size_t{1} << (k2005Bits - ColourTable::kBitsCr);
  const Yuv centre = ColourTable::centreOf(cell);
  const std::size_t y0 = std::size_t{centre.y} / 2 / kY * kY;
  const std::size_t cr0 = std::size_t{centre.cr} / 2 / kC * kC;
  const std::size_t cb0 = std::size_t{centre.cb} / 2 / kC * kC;
  std::array<int, kColourClassCount> votes{};
  for (std::size_t i = 0; i < kY * kC * kC; ++i) {
    const std::size_t at = fineIndex(y0 + i / (kC * kC), cr0 + i / kC % kC, cb0 + i % kC);
    ++votes[index(classOf2005(fine[at]))];
  }
  std::size_t best = 0;
  for (std::size_t c = 1; c < kColourClassCount; ++c) {
    if (votes[c] > votes[best]) best = c;
  }
  return static_cast<ColourClass>(best);
}

ColourTable reduced(const Bytes& fine) {
  ColourTable table;
  for (std::size_t cell = 0; cell < ColourTable::kCells; ++cell)
    table.set(cell, majority(fine, cell));
  return table;
}

Expected<ColourTable> fromOwnFile(const std::string& path, const Bytes& bytes) {
  ColourTable table;
  auto file = parseTableFile(path, bytes, TableKind::colour, table.cells.size());
  if (!file) return Error{file.error()};
  for (std::size_t i = 0; i < table.cells.size(); ++i) {
    const std::uint8_t pair = file->data[i];
    if ((pair & ColourTable::kClassMask) >= kColourClassCount || (pair >> 4) >= kColourClassCount) {
      return Error{path + ": colour class out of range in data byte " + std::to_string(i)};
    }
    table.cells[i] = pair;
  }
  return table;
}

}  // namespace

ColourClass classOf2005(std::uint8_t id) {
  switch (id & static_cast<std::uint8_t>(~kMaybeBit)) {
    case 0: return ColourClass::orange;
    case 1: return ColourClass::blue;
    case 3: return ColourClass::yellow;
    case 4: return ColourClass::pink;
    case 5: return ColourClass::robotBlue;
    case 6: return ColourClass::robotRed;
    case 7: return ColourClass::green;
    case 8: return ColourClass::grey;
    case 9: return ColourClass::white;
    case 10: return ColourClass::black;
    default: return ColourClass::none;
  }
}

Yuv ColourTable::centreOf(std::size_t cell) {
  const std::size_t y = cell >> (kBitsCr + kBitsCb);
  const std::size_t cr = (cell >> kBitsCb) & ((1U << kBitsCr) - 1U);
  const std::size_t cb = cell & ((1U << kBitsCb) - 1U);
  return {middle(y, kBitsY), middle(cr, kBitsCr), middle(cb, kBitsCb)};
}

Expected<ColourTable> loadColourTable(const std::string& path) {
  auto bytes = readBytes(path);
  if (!bytes) return Error{bytes.error()};
  if (looksLikeTableFile(*bytes)) return fromOwnFile(path, *bytes);
  if (bytes->size() == k2005Size) return reduced(*bytes);
  return Error{path + ": " + std::to_string(bytes->size()) +
               " bytes, expected 2097152 (128^3) or a Kelpie colour table"};
}

Status saveColourTable(const ColourTable& table, const std::string& path,
                       const std::string& provenance) {
  return writeTableFile(
      path, {TableKind::colour, provenance, Bytes(table.cells.begin(), table.cells.end())});
}

}  // namespace kelpie::vision
