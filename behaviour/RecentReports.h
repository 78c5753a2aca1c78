// SPDX-License-Identifier: Apache-2.0
// The last lines that were reported to people: of a script that went wrong, each different error
// once (README.md), and what scripts print. Whoever reads them keeps how many it has read.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace kelpie::behaviour {

struct ReportLine {
  std::string text;
  bool fault = false;  // something went wrong; otherwise a script prints
};

struct RecentReports {
  // More than one frame tells: ten lines that scripts print (PrintedLines.h), how many were left
  // out, and an error.
  static constexpr std::uint32_t kKept = 16;

  std::uint32_t number = 0;  // of all so far
  std::array<ReportLine, kKept> lines;

  void add(const std::string& text, bool fault) { lines[number++ % kKept] = {text, fault}; }
  // The oldest that is kept and not among the first `read`, which then counts it; null: none.
  const ReportLine* next(std::uint32_t& read) const {
    if (read == number) return nullptr;
    if (number - read > kKept) read = number - kKept;
    return &lines[read++ % kKept];
  }
};

}  // namespace kelpie::behaviour
