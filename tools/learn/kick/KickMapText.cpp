// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "tools/learn/kick/KickMapFile.h"

namespace kelpie::learn {
namespace {

constexpr std::size_t kColumns = 100;

constexpr const char* kHead = R"(# SPDX-License-Identifier: Apache-2.0
# Where each kick sends the ball from each place, how far and how sure, measured on varied physical
# models; lib/kick_table.py reads it. Fails for a ball that rolls and for a robot that is pushed.
# Written by a command, not to be edited:
)";

constexpr const char* kLegend = R"(#
# Lengths in cm, directions in deg left of ahead. An outcome: percent of the runs in which the ball
# went further than 30 cm; its direction, standard deviation (sd); how far it rolls when nothing
# stops it, sd; percent of the runs in which the robot fell. None: the robot's body is in the way.
# STANDING and WALKING, a robot that stands, or walks until it kicks, and a ball that lies on the
# carpet; from walking, as it all will be when the motion begins. 'places' has a row of outcomes for
# each distance 'ahead', from the nearest; an outcome in it for each place 'aside', to the right,
# from the leftmost. A kick that is its own mirror image has the places to the right alone, a pair
# its left kick alone. 'best' is the place with the best neighbours, 'window' two corners of the
# places about it from where at least 80 % go about the same way, 'whole' the outcome over them.
# HELD, a ball in the hold: 'whole' alone. 'frames' of 1/30 s that the kick takes; 'way' of the
# robot until it stands again: right, ahead, deg turned to the left.
# UNTIL_KICK: s from asking until a walking robot's motion begins, on the mean.
import kelpie

)";

// No "-0".
std::string number(double value, int digits) {
  const std::string text = fmt::format("{:.{}f}", value, digits);
  return text.find_first_not_of("-0.") == std::string::npos ? fmt::format("{:.{}f}", 0.0, digits)
                                                            : text;
}

std::string place(Point2<Robot> point) {
  return fmt::format("({}, {})", number(point.x, 0), number(point.y, 0));
}

std::string outcome(const KickCell& cell) {
  if (cell.runs == 0) return "None";
  const auto percent = [](double share) { return number(100.0 * share, 0); };
  return fmt::format("({}, {}, {}, {}, {}, {})", percent(cell.went),
                     number(cell.direction.deg(), 0), number(cell.directionSd.deg(), 0),
                     number(cell.distance, 0), number(cell.distanceSd, 0), percent(cell.fell));
}

std::string nameOf(MotionKind motion) {
  std::string name = actuator::kMotionNames[static_cast<std::size_t>(motion)];
  for (char& letter : name) letter = static_cast<char>(std::toupper(letter));
  return "kelpie." + name;
}

std::string list(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number(value, 0);
  return fmt::format("({})", text);
}

// A row of outcomes, broken where the line would be too long.
std::string row(const KickGrid& grid, std::size_t index) {
  const std::string indent(13, ' ');
  std::string text;
  std::string line = "            (";
  for (std::size_t column = 0; column < grid.lateral.size(); ++column) {
    const bool last = column + 1 == grid.lateral.size();
    const std::string next = outcome(grid.cell(index, column)) + (last ? ")," : ",");
    if (line.size() + next.size() + 1 > kColumns) {
      text += line + "\n";
      line = indent;
    } else if (column > 0) {
      line += " ";
    }
    line += next;
  }
  return text + line + "\n";
}

std::string places(const KickGrid& grid) {
  std::string text = fmt::format("        'ahead': {},\n        'aside': {},\n", list(grid.ahead),
                                 list(grid.lateral));
  text += fmt::format("        'best': {}, 'window': ({}, {}),\n        'places': (\n",
                      place(grid.window.best), place(grid.window.min), place(grid.window.max));
  for (std::size_t index = 0; index < grid.ahead.size(); ++index) text += row(grid, index);
  return text + "        ),\n";
}

std::string kick(const KickGrid& grid) {
  std::string text = fmt::format("    {}: {{\n", nameOf(grid.motion));
  text += fmt::format("        'frames': {}, 'way': ({}, {}, {}),\n", number(grid.frames, 0),
                      number(-grid.way.left, 1), number(grid.way.forward, 1),
                      number(grid.way.turn.deg(), 0));
  text += fmt::format("        'whole': {},\n", outcome(grid.window.whole));
  if (grid.from != KickFrom::hold) text += places(grid);
  return text + "    },\n";
}

}  // namespace

std::string kickMapText(const KickMap& map, const std::string& about) {
  std::string text = kHead;
  std::size_t start = 0;
  while (start < about.size()) {
    const std::size_t end = std::min(about.find('\n', start), about.size());
    text += "#   " + about.substr(start, end - start) + "\n";
    start = end + 1;
  }
  text += kLegend;
  text += fmt::format("UNTIL_KICK = {}\n", kUntilKick);
  for (std::size_t from = 0; from < kKickFroms; ++from) {
    text += fmt::format("\n{} = {{\n", kKickFromNames[from]);
    for (const KickGrid& grid : map)
      if (static_cast<std::size_t>(grid.from) == from) text += kick(grid);
    text += "}\n";
  }
  return text;
}

}  // namespace kelpie::learn
