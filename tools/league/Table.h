// SPDX-License-Identifier: Apache-2.0
// A league's tables for people: text, a picture, and a page that needs neither scripts nor network.
// All three show the same cells.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/league/Standings.h"

namespace kelpie::league {

struct TableRow {
  std::vector<std::string> cells;
  // Goals a match, where there are observations: drawn beside the row.
  std::optional<Interval> interval;
  double mean = 0.0;
};

// Names stand left, numbers right.
struct Table {
  std::string title;
  std::vector<std::string> heads;
  std::size_t names = 1;  // columns with names, first
  std::vector<TableRow> rows;
};

// Rank, matches, wins, draws, losses, points, goals, difference with its interval, p.
Table sideTable(const Standings& standings);
// Each pair with both tests.
Table pairTable(const Standings& standings);
// What was asked, what of it has been played, what is void or left out.
std::vector<std::string> summaryOf(const Standings& standings);
// How to read the tables.
std::vector<std::string> notesOf(const Standings& standings);

std::string textOf(const Standings& standings);
std::string pageOf(const Standings& standings);                             // TablePage.cpp
Status drawTables(const Standings& standings, const std::string& pngPath);  // TablePicture.cpp

// FOLDER/table.txt, table.html and table.png, each whole or not at all.
Status writeTables(const Standings& standings, const std::string& folder);

}  // namespace kelpie::league
