// SPDX-License-Identifier: Apache-2.0
#include "tools/league/Table.h"

#include <fmt/core.h>

#include <algorithm>

#include "tools/cli/WholeFile.h"
#include "tools/league/JournalLines.h"

namespace kelpie::league {
namespace {

std::string number(int value) { return fmt::format("{}", value); }

std::string goalsOf(const Score& score) { return fmt::format("{}:{}", score.goals, score.against); }

std::string difference(const PairedStatistics& of) {
  return of.count == 0 ? "-" : fmt::format("{:+.2f}", of.mean);
}

std::string interval(const PairedStatistics& of) {
  if (of.count < 2) return "-";
  return fmt::format("{:+.2f} .. {:+.2f}", of.bootstrap.low, of.bootstrap.high);
}

// Never "0.0000": no test is that sure.
std::string probability(double p) { return p < 0.0001 ? "<0.0001" : fmt::format("{:.4f}", p); }

std::string flipped(const PairedStatistics& of, double p) {
  return of.count == 0 ? "-" : probability(p);
}

TableRow rowOf(std::vector<std::string> cells, const PairedStatistics& of) {
  TableRow row{std::move(cells), std::nullopt, of.mean};
  if (of.count >= 2) row.interval = of.bootstrap;
  return row;
}

std::vector<std::size_t> widthsOf(const Table& table) {
  std::vector<std::size_t> widths;
  for (std::size_t column = 0; column < table.heads.size(); ++column) {
    std::size_t width = table.heads[column].size();
    for (const TableRow& row : table.rows) width = std::max(width, row.cells[column].size());
    widths.push_back(width);
  }
  return widths;
}

std::string lineOf(const Table& table, const std::vector<std::string>& cells,
                   const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t column = 0; column < cells.size(); ++column) {
    if (column > 0) line += "  ";
    line += column < table.names ? fmt::format("{:<{}}", cells[column], widths[column])
                                 : fmt::format("{:>{}}", cells[column], widths[column]);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string textOfTable(const Table& table) {
  const auto widths = widthsOf(table);
  std::string text = "\n" + table.title + "\n\n" + lineOf(table, table.heads, widths);
  for (const TableRow& row : table.rows) text += lineOf(table, row.cells, widths);
  return text;
}

}  // namespace

Table sideTable(const Standings& standings) {
  Table table{"Sides",
              {"side", "matches", "won", "drawn", "lost", "points", "goals", "own goals",
               "goals a match", "95 % interval", "p"},
              1,
              {}};
  for (const SideStanding& side : standings.sides) {
    const Score& score = side.score;
    const PairedStatistics& of = side.difference;
    table.rows.push_back(
        rowOf({side.name, number(score.matches), number(score.wins), number(score.draws),
               number(score.losses), number(score.points()), goalsOf(score), number(score.ownGoals),
               difference(of), interval(of), flipped(of, of.signFlip.p.twoSided)},
              of));
  }
  return table;
}

Table pairTable(const Standings& standings) {
  Table table{"Pairs",
              {"side", "against", "seeds", "won", "drawn", "lost", "goals", "goals a match",
               "95 % interval", "S", "t", "p of t", "p", "p one-sided"},
              2,
              {}};
  for (const PairStanding& pair : standings.pairs) {
    const Score& score = pair.score;
    const PairedStatistics& of = pair.difference;
    table.rows.push_back(rowOf(
        {pair.first, pair.second, fmt::format("{}", of.count), number(score.wins),
         number(score.draws), number(score.losses), goalsOf(score), difference(of), interval(of),
         of.count < 2 ? "-" : fmt::format("{:.2f}", of.spread),
         of.t ? fmt::format("{:+.2f}", of.t->t) : "-", of.t ? probability(of.t->p.twoSided) : "-",
         flipped(of, of.signFlip.p.twoSided), flipped(of, of.signFlip.p.oneSided)},
        of));
  }
  return table;
}

std::vector<std::string> summaryOf(const Standings& standings) {
  const LeaguePlan& plan = standings.plan;
  const std::uint64_t last = plan.seed + static_cast<std::uint64_t>(plan.matchesAPair / 2 - 1);
  std::vector<std::string> lines{
      fmt::format("League {}: {} sides, {} matches a pair of {:g} min{}, seeds {} to {}",
                  hashOf(plan), plan.sides.size(), plan.matchesAPair, plan.minutes,
                  plan.fast ? ", kinematic bodies" : "", plan.seed, last),
      fmt::format("{} of {} matches counted, {} to be played, {} void, {} without the seed's other "
                  "match",
                  standings.counted, standings.matches, standings.left(), standings.voids,
                  standings.unpaired)};
  if (!plan.reference.empty()) lines.push_back("All play against " + plan.reference + " alone");
  for (const std::string& trouble : standings.troubles) lines.push_back("void: " + trouble);
  return lines;
}

std::vector<std::string> notesOf(const Standings& standings) {
  std::vector<std::string> notes{
      "Goals a match: the difference; the two matches of a seed, colours exchanged, are one "
      "observation.",
      "Interval: bootstrap percentiles. p: sign-flip test, of a difference as large by luck alone; "
      "one-sided: of the first being so much better."};
  const std::size_t pairs = standings.pairs.size();
  if (pairs > 1)
    notes.push_back(
        fmt::format("Each p stands alone: of {} pairs without any difference some pair "
                    "has p < {:.4f} in one league of twenty.",
                    pairs, 0.05 / static_cast<double>(pairs)));
  return notes;
}

std::string textOf(const Standings& standings) {
  std::string text;
  for (const std::string& line : summaryOf(standings)) text += line + "\n";
  text += textOfTable(sideTable(standings)) + textOfTable(pairTable(standings)) + "\n";
  for (const std::string& line : notesOf(standings)) text += line + "\n";
  return text;
}

Status writeTables(const Standings& standings, const std::string& folder) {
  const std::string text = folder + "/table.txt";
  const std::string page = folder + "/table.html";
  if (!cli::writeWhole(text, textOf(standings))) return Error{text + ": cannot be written"};
  if (!cli::writeWhole(page, pageOf(standings))) return Error{page + ": cannot be written"};
  return drawTables(standings, folder + "/table.png");
}

}  // namespace kelpie::league
