// SPDX-License-Identifier: Apache-2.0
// For the robot: logs without chunks, and no compressor in the program.
#include "robot/core/log/ChunkCodec.h"

namespace kelpie {

LogOptions defaultLogOptions() { return {}; }

std::unique_ptr<ChunkCompressor> makeCompressor(std::string_view /*compression*/) {
  return nullptr;
}

std::unique_ptr<ChunkDecompressor> makeDecompressor(std::string_view /*compression*/) {
  return nullptr;
}

}  // namespace kelpie
