// SPDX-License-Identifier: Apache-2.0
#include "behaviour/interpreter/PrintedLines.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace kelpie::behaviour {

std::uint32_t PrintedLines::begin(TimeUs now) {
  const double passed = (now - begun_).seconds();
  if (passed >= 0.0 && passed < 1.0) return 0;  // a log's time may begin anew
  begun_ = now;
  lines_ = 0;
  return std::exchange(leftOut_, 0);
}

bool PrintedLines::admits() {
  if (lines_ == params_.linesPerSecond) {
    ++leftOut_;
    return false;
  }
  ++lines_;
  return true;
}

std::string PrintedLines::shown(const std::string& line) const {
  const auto byteAt = [&line](std::size_t i) { return static_cast<unsigned char>(line[i]); };
  std::size_t end = std::min<std::size_t>(line.size(), params_.longest);
  while (end > 0 && end < line.size() && (byteAt(end) & 0xc0U) == 0x80) --end;
  std::string text = line.substr(0, end);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return (c >= 0 && c < ' ') || c == 0x7f; }, '?');
  if (end == line.size()) return text;
  return text + "... (" + std::to_string(line.size() - end) + " bytes more)";
}

}  // namespace kelpie::behaviour
