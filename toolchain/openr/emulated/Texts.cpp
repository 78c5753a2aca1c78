// SPDX-License-Identifier: Apache-2.0
// Lets tests/toolchain put a text through the parts of std::string that the object brings itself
// (Strings.cpp): growth, appending, and replacing by something shorter and longer.
#include <cstdint>
#include <cstring>
#include <string>

extern "C" {

std::uint8_t* kelpieBuffer();

// Of what lies in the buffer, put there again.
std::uint32_t kelpieTexts(std::uint32_t size) {
  const std::string given(reinterpret_cast<const char*>(kelpieBuffer()), size);
  std::string made = "a";
  for (int i = 0; i < 20; ++i) made.append(given);
  made.replace(3, 7, given);
  made.replace(1, 30, "-");
  made += '!';
  std::string copy;
  copy.assign(made, 2, 100);
  made.insert(0, copy);
  std::memcpy(kelpieBuffer(), made.data(), made.size());
  return static_cast<std::uint32_t>(made.size());
}
}
