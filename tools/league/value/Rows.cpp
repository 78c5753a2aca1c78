// SPDX-License-Identifier: Apache-2.0
#include "tools/league/value/Rows.h"

#include <fmt/core.h>

namespace kelpie::value {
namespace {

int endFor(const Stretch& stretch, TeamColour team) {
  if (!stretch.goal) return 0;
  return *stretch.goal == team ? 1 : -1;
}

}  // namespace

std::vector<Row> rowsOf(const PlayedTruth& match, const body::FieldDescription& field,
                        double apart) {
  std::vector<Row> rows;
  for (const Stretch& stretch : stretchesOf(match)) {
    const FrameRange range = framesOf(match, stretch);
    double next = stretch.begin;
    for (std::size_t i = range.first; i < range.last; ++i) {
      const sim::TruthFrame& truth = match.frames[i];
      const double now = truth.time.seconds();
      if (now < next) continue;
      next = now + apart;
      for (const TeamColour team : {TeamColour::red, TeamColour::blue})
        rows.push_back({now, team, stretch.end - now, endFor(stretch, team),
                        featuresOf(stateOf(truth, team, field), field)});
    }
  }
  return rows;
}

void writeHead(std::ostream& out) {
  out << "match,seconds,team,left,ends";
  forEachFieldOf<Features>([&](const auto& f) { out << ',' << f.name; });
  out << '\n';
}

void writeRows(const std::vector<Row>& rows, const std::string& match, std::ostream& out) {
  for (const Row& row : rows) {
    const char* const team = row.team == TeamColour::red ? "red" : "blue";
    out << fmt::format("{},{:.3f},{},{:.3f},{}", match, row.seconds, team, row.left, row.ends);
    forEachField(row.features,
                 [&](const auto&, double value) { out << fmt::format(",{:.6g}", value); });
    out << '\n';
  }
}

}  // namespace kelpie::value
