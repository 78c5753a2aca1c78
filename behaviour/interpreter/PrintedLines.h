// SPDX-License-Identifier: Apache-2.0
// Bounds what scripts print: so many lines in a second of the robot's time, each so long. Counts
// the lines that are left out.
#pragma once

#include <cstdint>
#include <string>

#include "robot/core/Time.h"

namespace kelpie::behaviour {

struct PrintParams {
  std::uint32_t linesPerSecond = 10;  // four robots fill a screen in a second; more nobody reads
  std::uint32_t longest = 200;        // bytes of a line; the robot's system log takes 243
};

class PrintedLines {
 public:
  // A new frame: how many lines were left out of the second that has passed, if one has.
  std::uint32_t begin(TimeUs now);
  // Whether the second has room for one more line; otherwise it is counted.
  bool admits();
  std::uint32_t leftOut() const { return leftOut_; }
  // What is shown of a line in UTF-8: it is cut between two characters, and what would steer a
  // terminal is a question mark.
  std::string shown(const std::string& line) const;
  const PrintParams& params() const { return params_; }

 private:
  PrintParams params_;
  TimeUs begun_;  // of this second
  std::uint32_t lines_ = 0;
  std::uint32_t leftOut_ = 0;
};

}  // namespace kelpie::behaviour
