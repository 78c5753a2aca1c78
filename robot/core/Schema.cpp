// SPDX-License-Identifier: Apache-2.0
#include "robot/core/Schema.h"

#include <cmath>

namespace kelpie::detail {

std::string schemaLine(const std::string& type, const char* name, const std::string& comment) {
  std::string line = type + ' ' + name;
  if (!comment.empty()) line += "  # " + comment;
  return line + '\n';
}

std::string rangeText(const char* unit, bool isAngle, double min, double max) {
  std::string text = unit;
  if (!std::isfinite(min) && !std::isfinite(max)) return text;
  if (!text.empty()) text += ", ";
  if (std::isfinite(min)) text += numberText(min);
  text += "..";
  if (std::isfinite(max)) text += numberText(max);
  if (isAngle) text += " deg";
  return text;
}

std::string joinSections(const SchemaSections& sections) {
  std::string text;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (i > 0) text += std::string(80, '=') + "\nMSG: " + sections[i].first + '\n';
    text += sections[i].second;
  }
  return text;
}

}  // namespace kelpie::detail
