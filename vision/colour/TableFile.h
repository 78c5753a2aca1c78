// SPDX-License-Identifier: Apache-2.0
// Kelpie's own calibration files: magic, version, kind, provenance text, data and a checksum of all
// that precedes it. Read and written at start-up only; anything wrong is one line naming the file.
//
//   "KELPIETB" | u32 version | u32 kind | u32 text length | u32 data length | text | data | u32 FNV
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie::vision {

enum class TableKind : std::uint32_t { colour = 1, ring = 2 };

using Bytes = std::vector<std::uint8_t>;

struct TableFile {
  TableKind kind = TableKind::colour;
  std::string provenance;  // tool, robot, venue, residual: for people
  Bytes data;
};

Expected<Bytes> readBytes(const std::string& path);
bool looksLikeTableFile(const Bytes& bytes);
// `path` names the file in errors; the data must be `dataSize` bytes of the wanted kind.
Expected<TableFile> parseTableFile(const std::string& path, const Bytes& bytes, TableKind kind,
                                   std::size_t dataSize);
Status writeTableFile(const std::string& path, const TableFile& file);

}  // namespace kelpie::vision
