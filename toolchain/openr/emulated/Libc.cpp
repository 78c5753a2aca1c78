// SPDX-License-Identifier: Apache-2.0
// The few functions of the C library and of libgcc that the object wants of the SDK, for the
// emulator alone: the robot's come from the SDK. Memory is python-openr/libc/Memory.c's.
#include <cstddef>
#include <cstdint>

extern "C" {

void* memcpy(void* to, const void* from, std::size_t count);

// The one file that there is, by whatever name: its size, then its bytes.
static const std::uint32_t* fileHead = nullptr;
static std::size_t fileAt = 0;

// From now on it lies there.
void kelpieFile(const std::uint32_t* head) { fileHead = head; }
void* fopen(const char* /*path*/, const char* /*mode*/) {
  fileAt = 0;
  return const_cast<std::uint32_t*>(fileHead);
}
std::size_t fread(void* to, std::size_t size, std::size_t count, void* /*file*/) {
  const std::size_t left = (*fileHead - fileAt) / size;
  const std::size_t taken = count < left ? count : left;
  memcpy(to, reinterpret_cast<const std::uint8_t*>(fileHead + 1) + fileAt, taken * size);
  fileAt += taken * size;
  return taken;
}
int setvbuf(void* /*file*/, char* /*buffer*/, int /*mode*/, std::size_t /*size*/) { return 0; }
int ferror(void* /*file*/) { return 0; }
int fclose(void* /*file*/) { return 0; }

// In place of every function of OPEN-R.
void kelpieNoOpenr() { __builtin_trap(); }

void* memcpy(void* to, const void* from, std::size_t count) {
  auto* out = static_cast<std::uint8_t*>(to);
  const auto* in = static_cast<const std::uint8_t*>(from);
  const bool aligned =
      ((reinterpret_cast<std::uintptr_t>(out) | reinterpret_cast<std::uintptr_t>(in)) & 3U) == 0;
  if (aligned) {
    for (; count >= 4; count -= 4, out += 4, in += 4)
      *reinterpret_cast<std::uint32_t*>(out) = *reinterpret_cast<const std::uint32_t*>(in);
  }
  while (count-- > 0) *out++ = *in++;
  return to;
}

void* memmove(void* to, const void* from, std::size_t count) {
  auto* out = static_cast<std::uint8_t*>(to);
  const auto* in = static_cast<const std::uint8_t*>(from);
  if (out <= in || out >= in + count) return memcpy(to, from, count);
  while (count-- > 0) out[count] = in[count];
  return to;
}

void* memset(void* to, int value, std::size_t count) {
  auto* out = static_cast<std::uint8_t*>(to);
  while (count-- > 0) *out++ = static_cast<std::uint8_t>(value);
  return to;
}

int memcmp(const void* a, const void* b, std::size_t count) {
  const auto* left = static_cast<const std::uint8_t*>(a);
  const auto* right = static_cast<const std::uint8_t*>(b);
  for (; count-- > 0; ++left, ++right)
    if (*left != *right) return *left < *right ? -1 : 1;
  return 0;
}

std::size_t strlen(const char* text) {
  std::size_t length = 0;
  while (text[length] != '\0') ++length;
  return length;
}

// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): libgcc's names
// From 64-bit integers to doubles and back, by parts that a double holds exactly: 32 bits each.
double __floatdidf(std::int64_t value) {
  const auto high = static_cast<double>(static_cast<std::int32_t>(value >> 32));
  const auto low = static_cast<double>(static_cast<std::uint32_t>(value));
  return high * 4294967296.0 + low;  // the product is exact, the sum rounded once
}

std::uint64_t __fixunsdfdi(double value) {
  const auto high = static_cast<std::uint32_t>(value / 4294967296.0);
  const auto low = static_cast<std::uint32_t>(value - static_cast<double>(high) * 4294967296.0);
  return (static_cast<std::uint64_t>(high) << 32) | low;
}

std::int64_t __fixdfdi(double value) {
  return value < 0.0 ? -static_cast<std::int64_t>(__fixunsdfdi(-value))
                     : static_cast<std::int64_t>(__fixunsdfdi(value));
}

// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)

double sqrt(double x) { return __builtin_sqrt(x); }  // the instruction: -fno-math-errno
double fmin(double x, double y) { return x != x ? y : y != y || x < y ? x : y; }
double fmax(double x, double y) { return x != x ? y : y != y || x > y ? x : y; }
}
