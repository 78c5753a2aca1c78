// SPDX-License-Identifier: Apache-2.0
#include "behaviour/views/PythonNames.h"

#include <string_view>

namespace kelpie::behaviour {

std::string snakeCase(const char* name) {
  std::string text;
  for (const char* c = name; *c != '\0'; ++c) {
    const bool upper = *c >= 'A' && *c <= 'Z';
    if (upper && c != name) text += '_';
    text += upper ? static_cast<char>(*c - 'A' + 'a') : *c;
  }
  return text;
}

const char* unitSuffix(const char* unit) {
  const std::string_view text = unit;
  if (text == "rad" || text == "rad/s" || text == "rad/frame") return "_deg";
  return text == "rad2" ? "_deg2" : "";
}

double shownFactor(const char* unit) {
  constexpr double kDegrees = 180.0 / maths::kPi;
  const std::string_view suffix = unitSuffix(unit);
  if (suffix == "_deg") return kDegrees;
  return suffix == "_deg2" ? kDegrees * kDegrees : 1.0;
}

}  // namespace kelpie::behaviour
