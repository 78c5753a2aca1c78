// SPDX-License-Identifier: Apache-2.0
// A colour table or ring correction: the bytes as they are, or laid over a sound file, whose
// checksum is made right again or not (the 2 MB of 2005 have no structure). What is taken has known
// classes and allowed centres, and is read again as it is written.
#include <memory>

#include "robot/core/fields/FieldCheck.h"
#include "tests/fuzz/Input.h"
#include "vision/colour/ColourTable.h"
#include "vision/colour/RingTable.h"
#include "vision/colour/TableFile.h"

namespace {

using namespace kelpie;
using fuzz::require;

fuzz::Bytes soundFile(bool ring) {
  const std::string name = fuzz::placeOf("-sound");
  if (ring) {
    static_cast<void>(vision::saveRingTable(vision::buildRingTable({}), name, "fuzz"));
  } else {
    static_cast<void>(vision::saveColourTable(vision::ColourTable{}, name, "fuzz"));
  }
  const auto bytes = vision::readBytes(name);
  std::remove(name.c_str());
  return *bytes;
}

// The last four bytes: FNV-1a of all that precedes them.
void seal(fuzz::Bytes& bytes) {
  if (bytes.size() < 4) return;
  std::uint32_t hash = 2166136261U;
  for (std::size_t i = 0; i + 4 < bytes.size(); ++i) hash = (hash ^ bytes[i]) * 16777619U;
  for (std::size_t i = 0; i < 4; ++i)
    bytes[bytes.size() - 4 + i] = static_cast<std::uint8_t>(hash >> (8 * i));
}

// The first byte says which, 0 to 2.
fuzz::Bytes tableOf(fuzz::Input& input) {
  const unsigned how = input.byte() % 3U;
  if (how == 0) return input.rest();
  static const fuzz::Bytes kColour = soundFile(false), kRing = soundFile(true);
  fuzz::Bytes bytes = how == 1 ? kColour : kRing;
  const bool right = input.byte() % 2 == 0;
  fuzz::layOver(input, bytes);
  if (right) seal(bytes);
  return bytes;
}

void checkColour(const std::string& name) {
  const auto table = vision::loadColourTable(name);
  if (!table) return fuzz::requireLine(table.error(), name);
  require(std::all_of(table->cells.begin(), table->cells.end(),
                      [](std::uint8_t pair) {
                        return (pair & 15U) < vision::kColourClassCount &&
                               pair >> 4U < vision::kColourClassCount;
                      }),
          "known classes alone");
  const std::string again = fuzz::placeOf("-again");
  require(bool(vision::saveColourTable(*table, again, "")), "it can be written");
  const auto back = vision::loadColourTable(again);
  require(back && back->cells == table->cells, "and read as it was");
  std::remove(again.c_str());
}

void checkRing(const std::string& name) {
  const auto table = vision::loadRingTable(name);
  if (!table) return fuzz::requireLine(table.error(), name);
  static const vision::RingDistances distances;
  for (const int column : {0, kImageWidth - 1})
    for (const int row : {0, kImageHeight - 1})
      static_cast<void>((*table)({1, 2, 3}, distances(column, row, table->centre)));
  const std::string again = fuzz::placeOf("-again");
  require(bool(vision::saveRingTable(*table, again, "")), "it can be written");
  const auto back = vision::loadRingTable(again);
  require(back && !firstDifference(*back, *table, nullptr), "and read as it was");
  std::remove(again.c_str());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const fuzz::File file(tableOf(input));
  checkColour(file.name());
  checkRing(file.name());
  return 0;
}
