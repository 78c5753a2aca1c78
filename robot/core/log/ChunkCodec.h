// SPDX-License-Identifier: Apache-2.0
// Compression of a log's chunks, and decompression. A host program is linked with
// ZstdCompressor.cpp and ZstdDecompressor.cpp, which write and read chunks with zstd; one for the
// robot with NoChunkCodec.cpp, which writes no chunks and needs no compressor.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie {

// Takes the records of a chunk out of the caller's hands and compresses them while the caller goes
// on, one chunk at a time. How long that takes changes no byte of the result.
class ChunkCompressor {
 public:
  ChunkCompressor() = default;
  ChunkCompressor(const ChunkCompressor&) = delete;
  ChunkCompressor& operator=(const ChunkCompressor&) = delete;
  virtual ~ChunkCompressor() = default;

  virtual void start(std::vector<std::uint8_t>& records) = 0;
  virtual bool ready() const = 0;  // finish() will not wait
  // What start() was given, compressed, in place of what `to` holds.
  virtual Status finish(std::vector<std::uint8_t>& to) = 0;
};

class ChunkDecompressor {
 public:
  ChunkDecompressor() = default;
  ChunkDecompressor(const ChunkDecompressor&) = delete;
  ChunkDecompressor& operator=(const ChunkDecompressor&) = delete;
  virtual ~ChunkDecompressor() = default;

  // Replaces what `to` holds. `count` is what the chunk says of itself; anything else is an error,
  // and memory is taken only for as much as `size` bytes can hold.
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

// These three are in the files that the program links. The last two give null when it cannot do it.
LogOptions defaultLogOptions();
std::unique_ptr<ChunkCompressor> makeCompressor(std::string_view compression);
std::unique_ptr<ChunkDecompressor> makeDecompressor(std::string_view compression);

}  // namespace kelpie
