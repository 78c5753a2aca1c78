// SPDX-License-Identifier: Apache-2.0
// The parts of std::string that the compiler does not put where they are used, but expects in its
// library; the SDK's library is of 2003 and has another string. The linker keeps those that are
// used.
#include <charconv>
#include <cstddef>
#include <string>

template class std::basic_string<char>;

// The number in the text of a refusal (robot/core/fields/FieldCheck.h). A packet of the team is
// refused on the robot too, but its text is read by nobody there: the packet is counted.
std::to_chars_result std::to_chars(char* first, char* last, double /*number*/) noexcept {
  if (first == last) return {last, std::errc::value_too_large};
  *first = '?';
  return {first + 1, std::errc{}};
}

// std::string::find wants it; of the SDK's library it was not compared.
extern "C" void* memchr(const void* from, int value, std::size_t count) {
  const auto* in = static_cast<const unsigned char*>(from);
  for (; count > 0; --count, ++in)
    if (*in == static_cast<unsigned char>(value)) return const_cast<unsigned char*>(in);
  return nullptr;
}
