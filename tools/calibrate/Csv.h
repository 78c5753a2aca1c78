// SPDX-License-Identifier: Apache-2.0
// Rows of a comma-separated file with a known header. Errors name the file and the line.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie::calibrate {

using Cells = std::vector<std::string_view>;

// Calls take(cells) for each row with as many cells as the header; empty lines are passed over.
// What take returns as an error is put behind "file:line: ".
Status forEachRow(const std::string& path, const std::string& header,
                  const std::function<Status(const Cells&)>& take);
Cells cellsOf(std::string_view line, char separator);
// A finite number that fills the whole cell.
bool parseNumber(std::string_view cell, double& number);
bool parseByte(std::string_view cell, std::uint8_t& byte);

}  // namespace kelpie::calibrate
