// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/Csv.h"

#include <charconv>
#include <cmath>
#include <fstream>

namespace kelpie::calibrate {
namespace {

bool nextLine(std::ifstream& file, std::string& line) {
  if (!std::getline(file, line)) return false;
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return true;
}

// A spreadsheet that writes decimal commas parts its cells by semicolons, or puts numbers with a
// comma in quotes; where it does neither there are too many cells.
std::string otherColumns(const std::string& line, std::size_t wanted) {
  const bool semicolons = line.find(';') != std::string::npos;
  if (semicolons || line.find('"') != std::string::npos || cellsOf(line, ',').size() > wanted)
    return std::to_string(cellsOf(line, ',').size()) + " columns, expected " +
           std::to_string(wanted) +
           "; write numbers with a decimal point (12.5, not 12,5) and part them by commas";
  return "expected " + std::to_string(wanted) + " columns";
}

}  // namespace

Cells cellsOf(std::string_view line, char separator) {
  Cells cells;
  for (std::size_t from = 0;;) {
    const std::size_t to = line.find(separator, from);
    cells.push_back(line.substr(from, to - from));
    if (to == std::string_view::npos) return cells;
    from = to + 1;
  }
}

bool parseNumber(std::string_view cell, double& number) {
  const auto [rest, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  return error == std::errc() && rest == cell.data() + cell.size() && std::isfinite(number);
}

bool parseByte(std::string_view cell, std::uint8_t& byte) {
  const auto [rest, error] = std::from_chars(cell.data(), cell.data() + cell.size(), byte);
  return error == std::errc() && rest == cell.data() + cell.size();
}

Status forEachRow(const std::string& path, const std::string& header,
                  const std::function<Status(const Cells&)>& take) {
  std::ifstream file(path);
  if (!file) return Error{path + ": cannot be opened"};
  std::string line;
  const bool begun = nextLine(file, line);
  if (line.compare(0, 3, "\xEF\xBB\xBF") == 0) line.erase(0, 3);  // spreadsheets write a mark
  if (!begun || line != header)
    return Error{path + ":1: the header must be " + header +
                 (line.find(';') == std::string::npos
                      ? ""
                      : "; part columns by commas and write numbers with a decimal point")};
  const std::size_t columns = cellsOf(header, ',').size();
  for (int number = 2; nextLine(file, line); ++number) {
    if (line.empty()) continue;
    const Cells cells = cellsOf(line, ',');
    const Status taken = cells.size() == columns ? take(cells) : Error{otherColumns(line, columns)};
    if (!taken) return Error{path + ":" + std::to_string(number) + ": " + taken.error()};
  }
  return Done{};
}

}  // namespace kelpie::calibrate
