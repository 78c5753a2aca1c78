// SPDX-License-Identifier: Apache-2.0
// Compression of a log's chunks. The program links one of two files: ZstdChunkCodec.cpp (host)
// reads and writes chunks with zstd, NoChunkCodec.cpp (robot) writes no chunks and has no
// compressor.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie {

class ChunkCodec {
 public:
  ChunkCodec() = default;
  ChunkCodec(const ChunkCodec&) = delete;
  ChunkCodec& operator=(const ChunkCodec&) = delete;
  virtual ~ChunkCodec() = default;

  // Takes the records of a chunk out of the caller's hands and compresses them while the caller
  // goes on: one chunk at a time. Whether and how long that takes changes no byte of the result.
  virtual void start(std::vector<std::uint8_t>& records) = 0;
  virtual bool ready() const = 0;  // finish() will not wait
  // What start() was given, compressed, in place of what `to` holds.
  virtual Status finish(std::vector<std::uint8_t>& to) = 0;
  // `count` is what the chunk says of itself; anything else is an error, and memory is taken only
  // for as much as `size` bytes can hold.
  virtual Status decompress(const std::uint8_t* from, std::size_t size, std::size_t count,
                            std::vector<std::uint8_t>& to) = 0;
};

// How a log is written.
struct LogOptions {
  bool chunks = false;               // false: every record goes out alone, with one write
  std::string compression;           // of the chunks, as MCAP calls it; empty: none
  std::size_t chunkBytes = 1 << 20;  // a chunk is closed when it holds as much
  std::int64_t chunkUs = 1000000;    // and before it spans as much: what a killed process loses
};

// Both are in the file that the program links.
LogOptions defaultLogOptions();
// Null when the program cannot do it.
std::unique_ptr<ChunkCodec> makeChunkCodec(std::string_view compression);

}  // namespace kelpie
