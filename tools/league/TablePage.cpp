// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "tools/league/Table.h"

namespace kelpie::league {
namespace {

constexpr const char* kHead =
    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<title>Kelpie league</title>\n<style>\n"
    "body { font: 15px sans-serif; margin: 2em; color: #222; background: #fff }\n"
    "table { border-collapse: collapse; margin: 1em 0 }\n"
    "th, td { padding: 0.25em 0.7em; text-align: right; border-bottom: 1px solid #ddd }\n"
    "th.name, td.name { text-align: left }\n"
    "line { stroke: #999 } line.interval { stroke: #25b; stroke-width: 3 }\n"
    "circle { fill: #25b }\n</style>\n</head>\n<body>\n<h1>Kelpie league</h1>\n";

constexpr int kWide = 200;  // px of the drawn intervals
constexpr int kHigh = 18;

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&': safe += "&amp;"; break;
      case '<': safe += "&lt;"; break;
      case '>': safe += "&gt;"; break;
      case '"': safe += "&quot;"; break;
      default: safe += c;
    }
  }
  return safe;
}

double reachOf(const Table& table) {
  double reach = 0.5;  // goals a match
  for (const TableRow& row : table.rows)
    if (row.interval)
      reach = std::max({reach, std::fabs(row.interval->low), std::fabs(row.interval->high)});
  return reach;
}

// An interval as a bar, its mean as a dot, and the line of no difference.
std::string barOf(const TableRow& row, double reach) {
  if (!row.interval) return "";
  const auto x = [&](double goals) { return kWide * (0.5 + 0.47 * goals / reach); };
  const int middle = kHigh / 2;
  return fmt::format(
      "<svg width=\"{0}\" height=\"{1}\"><line x1=\"{2}\" y1=\"0\" x2=\"{2}\" y2=\"{1}\"/>"
      "<line class=\"interval\" x1=\"{3:.1f}\" y1=\"{4}\" x2=\"{5:.1f}\" y2=\"{4}\"/>"
      "<circle cx=\"{6:.1f}\" cy=\"{4}\" r=\"4\"/></svg>",
      kWide, kHigh, kWide / 2, x(row.interval->low), middle, x(row.interval->high), x(row.mean));
}

std::string rowOf(const Table& table, const char* tag, const std::vector<std::string>& cells,
                  const std::string& bar) {
  std::string row = "<tr>";
  for (std::size_t column = 0; column < cells.size(); ++column)
    row += fmt::format("<{0}{1}>{2}</{0}>", tag, column < table.names ? " class=\"name\"" : "",
                       escaped(cells[column]));
  return row + fmt::format("<{0}>{1}</{0}></tr>\n", tag, bar);
}

std::string pageOfTable(const Table& table) {
  const double reach = reachOf(table);
  std::string page = "<h2>" + escaped(table.title) + "</h2>\n<table>\n";
  page += rowOf(table, "th", table.heads, fmt::format("-{0:.1f} .. +{0:.1f}", reach));
  for (const TableRow& row : table.rows) page += rowOf(table, "td", row.cells, barOf(row, reach));
  return page + "</table>\n";
}

std::string paragraphs(const std::vector<std::string>& lines) {
  std::string page;
  for (const std::string& line : lines) page += "<p>" + escaped(line) + "</p>\n";
  return page;
}

}  // namespace

std::string pageOf(const Standings& standings) {
  return kHead + paragraphs(summaryOf(standings)) + pageOfTable(sideTable(standings)) +
         pageOfTable(pairTable(standings)) + paragraphs(notesOf(standings)) + "</body>\n</html>\n";
}

}  // namespace kelpie::league
