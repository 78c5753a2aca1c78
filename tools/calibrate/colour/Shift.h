// SPDX-License-Identifier: Apache-2.0
// The shift from one robot's colours to the base robot's, so that one colour table serves a team:
// per channel a straight line through pairs of the same paper seen by both (facts-2005 section 3).
// The noise is in the robot's single pixels, the base's values are means of a thousand; so the
// robot's value is fitted as a function of the base's and the line is turned round. (Fitting the
// other way flattens it by 0.3 to 3 % on the 2005 samples.)
#pragma once

#include <array>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "robot/core/types/Image.h"
#include "vision/colour/RingTable.h"

namespace kelpie::calibrate {

struct ShiftPair {
  Yuv robot;
  std::array<double, 3> base{};
};

// One robot on one day.
struct ShiftRow {
  std::string date;
  std::string dog;
  std::string mac;  // its low half, eight hexadecimal digits
  std::size_t samples = 0;
  vision::RobotShift shift;
};

// Fails when a channel's base values do not differ.
Expected<vision::RobotShift> fitShift(const std::vector<ShiftPair>& pairs);
// Fits every robot of a file such as ../shared/data/camera/linear_shift_samples.csv, in its order.
Expected<std::vector<ShiftRow>> fitShifts(const std::string& path);

}  // namespace kelpie::calibrate
