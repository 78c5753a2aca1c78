// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/colour/Shift.h"

#include <algorithm>

#include "tools/calibrate/Csv.h"
#include "tools/calibrate/ring/Sheets.h"

namespace kelpie::calibrate {
namespace {

constexpr const char* kHeader =
    "date,dog,mac_low4,base_dog,paper,y_dog,y_base_mean,u_dog,u_base_mean,v_dog,v_base_mean";
constexpr double kMinSlope = 0.2;  // robots measured in 2005 lie in 0.89 to 1.11

struct Group {
  ShiftRow row;
  std::vector<ShiftPair> pairs;
};

Group& groupOf(std::vector<Group>& groups, const Cells& cells) {
  const auto same = [&](const Group& g) {
    return g.row.date == cells[0] && g.row.dog == cells[1] && g.row.mac == cells[2];
  };
  // Rows of one robot stand together, so that looking from the end is quick.
  const auto found = std::find_if(groups.rbegin(), groups.rend(), same);
  if (found != groups.rend()) return *found;
  groups.push_back(
      {{std::string(cells[0]), std::string(cells[1]), std::string(cells[2]), 0, {}}, {}});
  return groups.back();
}

Expected<ShiftPair> pairOf(const Cells& cells) {
  ShiftPair pair;
  const std::array<std::uint8_t*, 3> robot{&pair.robot.y, &pair.robot.cr, &pair.robot.cb};
  for (std::size_t c = 0; c < 3; ++c) {
    if (!parseByte(cells[5 + 2 * c], *robot[c]) || !parseNumber(cells[6 + 2 * c], pair.base[c]))
      return Error{"expected a byte and a number for each channel"};
  }
  return pair;
}

}  // namespace

Expected<vision::RobotShift> fitShift(const std::vector<ShiftPair>& pairs) {
  vision::RobotShift shift;
  const auto count = static_cast<double>(pairs.size());
  for (std::size_t c = 0; c < 3; ++c) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const ShiftPair& pair : pairs) {
      const double base = pair.base[c];
      const double robot = channelOf(pair.robot, c);
      x += base;
      y += robot;
      xx += base * base;
      xy += base * robot;
    }
    const double spread = count * xx - x * x;
    const double slope = spread > 1.0 ? (count * xy - x * y) / spread : 0.0;
    if (slope < kMinSlope) return Error{"the papers' colours do not differ enough"};
    shift[c] = {1.0 / slope, -(y - slope * x) / count / slope};
  }
  return shift;
}

Expected<std::vector<ShiftRow>> fitShifts(const std::string& path) {
  std::vector<Group> groups;
  const Status read = forEachRow(path, kHeader, [&](const Cells& cells) -> Status {
    const auto pair = pairOf(cells);
    if (!pair) return Error{pair.error()};
    groupOf(groups, cells).pairs.push_back(*pair);
    return Done{};
  });
  if (!read) return Error{read.error()};
  if (groups.empty()) return Error{path + ": no samples"};
  std::vector<ShiftRow> rows;
  for (Group& group : groups) {
    const auto shift = fitShift(group.pairs);
    if (!shift) return Error{path + ": " + group.row.dog + ": " + shift.error()};
    group.row.samples = group.pairs.size();
    group.row.shift = *shift;
    rows.push_back(group.row);
  }
  return rows;
}

}  // namespace kelpie::calibrate
