// SPDX-License-Identifier: Apache-2.0
#include "robot/core/FieldCheck.h"

namespace kelpie::detail {

void prependName(const char* name, std::string* path) {
  const bool needsDot = !path->empty() && path->front() != '[' && path->front() != ':';
  *path = name + std::string(needsDot ? "." : "") + *path;
}

void prependIndex(std::size_t index, std::string* path) {
  const bool needsDot = !path->empty() && path->front() != ':';
  *path = '[' + std::to_string(index) + ']' + (needsDot ? "." : "") + *path;
}

std::string outsideText(double value, double min, double max, const std::string& unit) {
  const std::string shown = numberText(value) + (unit.empty() ? "" : ' ' + unit);
  if (!std::isfinite(value)) return ": " + shown + " is not finite";
  std::string range = std::isfinite(min) ? numberText(min) : "";
  range += "..";
  if (std::isfinite(max)) range += numberText(max);
  return ": " + shown + " is outside " + range;
}

}  // namespace kelpie::detail
