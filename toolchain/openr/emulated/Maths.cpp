// SPDX-License-Identifier: Apache-2.0
// Lets tests/toolchain put doubles through the functions of the C library that the image has, by
// memory: the emulator reads no floating point registers. Compiled with -fno-builtin, so that each
// is really called.
#include <cmath>
#include <cstdint>

namespace {

struct Asked {
  double x;
  double y;
  std::int64_t whole;
};

struct Answered {
  double floor;
  double ceil;
  double fmin;
  double fmax;
  double fromWhole;
  std::int64_t toWhole;
  std::int64_t lround;
};

}  // namespace

extern "C" {

std::uint8_t* kelpieBuffer();

// Of what lies in the buffer, put there again: always one at a time.
std::uint32_t kelpieMaths(std::uint32_t size) {
  if (size != sizeof(Asked)) return 0;
  const Asked asked = *reinterpret_cast<const Asked*>(kelpieBuffer());
  auto& answered = *reinterpret_cast<Answered*>(kelpieBuffer());
  answered = {floor(asked.x),
              ceil(asked.x),
              fmin(asked.x, asked.y),
              fmax(asked.x, asked.y),
              static_cast<double>(asked.whole),
              static_cast<std::int64_t>(asked.x),
              lround(asked.x)};
  return sizeof(Answered);
}
}
