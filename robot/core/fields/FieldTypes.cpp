// SPDX-License-Identifier: Apache-2.0
#include "robot/core/fields/FieldTypes.h"

#include <charconv>

namespace kelpie {
namespace {

bool isNameStart(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace

std::string detail::rosName(std::string_view compilerName) {
  std::string package;
  std::size_t end = compilerName.find("::");
  while (end != std::string_view::npos) {
    const std::string_view part = compilerName.substr(0, end);
    if (!part.empty() && isNameStart(part.front())) {
      if (!package.empty()) package += '_';
      package += part;
    }
    compilerName.remove_prefix(end + 2);
    end = compilerName.find("::");
  }
  if (package.empty()) package = "kelpie";
  return package + '/' + std::string(compilerName);
}

std::string numberText(double value) {
  std::array<char, 40> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  return std::string(text.data(), result.ptr);
}

}  // namespace kelpie
