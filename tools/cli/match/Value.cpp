// SPDX-License-Identifier: Apache-2.0
// kelpie value: goals, shots and expected goals of recorded matches, and whose doing was worth
// what; and the rows that the value is learnt from.
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <sstream>

#include "robot/body/FieldDescription.h"
#include "tools/cli/Commands.h"
#include "tools/cli/WholeFile.h"
#include "tools/league/value/Report.h"
#include "tools/league/value/Rows.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

struct ValueOptions {
  std::vector<std::string> logs;
  std::string rows;
  std::string models = value::modelFolder();
  std::string field = "2006";
};

constexpr double kApart = 0.5;  // s between moments of which rows are written

int writeRowsOf(const ValueOptions& options) {
  if (!canWrite(options.rows)) return fail(options.rows + ": cannot be written", kExitBadInput);
  std::ostringstream out;
  value::writeHead(out);
  for (const std::string& log : options.logs) {
    if (sameFile(log, options.rows)) return fail(log + ": is the log itself", kExitBadInput);
    const auto match = value::readTruth(log);
    if (!match) return fail(match.error(), kExitBadInput);
    const auto rows = value::rowsOf(*match, *body::fieldDescription(options.field), kApart);
    value::writeRows(rows, fs::path(log).stem().string(), out);
  }
  return writeWhole(options.rows, out.str())
             ? kExitDone
             : fail(options.rows + ": cannot be written", kExitMachine);
}

// The logs that `kelpie play --logs all` leaves beside a match's own.
std::vector<std::string> robotLogs(const std::string& log) {
  std::vector<std::string> logs;
  for (const char* team : {"red", "blue"})
    for (int player = 1; player <= 4; ++player) {
      const fs::path path = fs::path(log).parent_path() / fmt::format("{}-{}.mcap", team, player);
      if (fs::exists(path) && !sameFile(path.string(), log)) logs.push_back(path.string());
    }
  return logs;
}

// The match's own log may be the world's, without a robot.
Status readLeaves(const std::string& log, value::Leaves& leaves) {
  (void)leaves.read(log);
  if (fs::path(log).filename() != "match.mcap") return Done{};
  for (const std::string& robot : robotLogs(log)) {
    const Status read = leaves.read(robot);
    if (!read) return read;
  }
  return Done{};
}

int report(const ValueOptions& options) {
  const auto models = value::readModels(options.models);
  if (!models) return fail(models.error(), kExitBadInput);
  value::Report report;
  const body::FieldDescription field = *body::fieldDescription(options.field);
  for (const std::string& log : options.logs) {
    const auto figures = value::figuresOfLog(log, *models, field);
    if (!figures) return fail(figures.error(), kExitBadInput);
    value::Leaves leaves;
    const Status read = readLeaves(log, leaves);
    if (!read) return fail(read.error(), kExitBadInput);
    report.add(*figures, leaves);
  }
  fmt::print("{}", report.text());
  return kExitDone;
}

}  // namespace

void addValue(CommandLine& app, int& code) {
  auto command = app.subcommand("value", "Goals, shots and expected goals of recorded matches");
  auto options = std::make_shared<ValueOptions>();
  command.option("LOG", options->logs, "Logs of matches with what really happened")
      .required()
      .check(existingFile());
  command.option("--models", options->models, "Folder of near.json and far.json (default: ours)")
      .check(existingFolder());
  command.option("--rows", options->rows, "Writes moments of play as CSV to learn from, no report");
  command.option("--field", options->field, "2006, osaka2005 or 2004")
      .check(oneOf({"2006", "osaka2005", "2004"}))
      .showDefault();
  command.callback([options, &code] {
    code = options->rows.empty() ? report(*options) : writeRowsOf(*options);
  });
}

}  // namespace kelpie::cli
