// SPDX-License-Identifier: Apache-2.0
#include "robot/stick/StickFault.h"

#include <array>

namespace kelpie::stick {
namespace {

constexpr std::array<std::string_view, kStickFaultCount + 1> kTexts = {
    "is good",
    "is missing",
    "cannot be read",
    "is not a file that `kelpie stick` wrote",
    "has another version of the layout",
    "was written for another version of the program",
    "has parts that do not fit its length",
    "the CRC-32 of a part is wrong",
    "the hash of the whole is wrong",
    "ends too early",
    "goes on after its end",
    "holds a value that cannot be",
    "holds a number beyond its range",
    "is not the file that the stick was written with",
};

template <std::size_t N>
void append(Text<N>& to, std::string_view words) {
  for (const char c : words) to.push_back(static_cast<std::uint8_t>(c));
}

template <std::size_t N>
void appendNumber(Text<N>& to, std::uint32_t number) {
  if (number >= 10) appendNumber(to, number / 10);
  to.push_back(static_cast<std::uint8_t>('0' + number % 10));
}

}  // namespace

std::string_view textOf(StickFault fault) {
  const auto number = static_cast<std::size_t>(fault);
  return number < kTexts.size() ? kTexts[number] : "has an unknown fault";
}

Text<120> lineOf(const StickVerdict& verdict) {
  Text<120> line;
  append(line, verdict.file.view());
  append(line, ": ");
  append(line, textOf(verdict.fault));
  if (verdict.good()) return line;
  append(line, " (fault ");
  appendNumber(line, static_cast<std::uint32_t>(verdict.fault));
  append(line, ")");
  return line;
}

}  // namespace kelpie::stick
