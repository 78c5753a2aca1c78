// SPDX-License-Identifier: Apache-2.0
// Room for the chunks of a log while it is read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kelpie {

// Gives a buffer room for `bytes`, in powers of two; what it held is lost if it grows. Chunks are a
// megabyte give or take a message: room for exactly the largest so far was taken anew with each
// that was a little larger.
inline void growTo(std::vector<std::uint8_t>& buffer, std::size_t bytes) {
  if (bytes <= buffer.capacity()) return;
  std::size_t room = 1U << 16;
  while (room < bytes) room *= 2;
  std::vector<std::uint8_t>().swap(buffer);
  buffer.reserve(room);
}

}  // namespace kelpie
