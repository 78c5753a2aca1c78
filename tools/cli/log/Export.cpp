// SPDX-License-Identifier: Apache-2.0
// `kelpie export`: the logs of a match for the viewers that robot people use.
#include "tools/viewer/Export.h"

#include <fmt/core.h>
#include <sys/stat.h>

#include <algorithm>
#include <ctime>
#include <memory>

#include "tools/cli/Commands.h"
#include "tools/cli/Process.h"
#include "tools/cli/WholeFile.h"

namespace kelpie::cli {
namespace {

struct ExportOptions {
  std::vector<std::string> logs;
  std::string out;
  std::string start;
};

Expected<TimeUs> timeOf(const std::string& words) {
  std::tm time{};
  const char* const rest = strptime(words.c_str(), "%Y-%m-%dT%H:%M:%S", &time);
  if (rest == nullptr || (*rest != '\0' && std::string(rest) != "Z"))
    return Error{"--start " + words + ": is no time as 2006-06-14T10:00:00Z (UTC)"};
  return TimeUs{static_cast<std::int64_t>(timegm(&time)) * 1000000};
}

// A log does not say when it was played. Its file does, as long as nobody copied it: the earliest
// of several, to the second.
Expected<TimeUs> timeOfFiles(const std::vector<std::string>& logs) {
  std::time_t earliest = 0;
  for (const std::string& log : logs) {
    struct stat info {};
    if (stat(log.c_str(), &info) != 0) continue;  // whoever opens it says so
    earliest = earliest == 0 ? info.st_mtime : std::min(earliest, info.st_mtime);
  }
  return TimeUs{static_cast<std::int64_t>(earliest) * 1000000};
}

Status checkOut(const ExportOptions& options) {
  if (isDevice(options.out)) return Error{options.out + ": not a plain file"};
  for (const std::string& log : options.logs)
    if (sameFile(log, options.out)) return Error{options.out + ": is one of the logs"};
  if (!canWrite(options.out)) return Error{options.out + ": cannot be written"};
  return Done{};
}

struct Written {
  std::size_t messages = 0;
  viewer::Exported holds;
};

// What goes wrong with the file is the machine's fault, and sets the code so.
Expected<Written> writeTo(const std::string& part, const ExportOptions& options, TimeUs start,
                          int& code) {
  auto file = viewer::ViewerFile::create(part);
  if (!file) return Error{file.error()};
  const auto holds = viewer::exportLogs(options.logs, start, *file);
  const Status closed = file->close();
  if (!closed) code = kExitMachine;
  if (!closed) return Error{closed.error()};
  if (!holds) return Error{holds.error()};
  return Written{file->messages(), *holds};
}

int exportMatch(const ExportOptions& options) {
  catchInterrupts();
  const Status sound = checkOut(options);
  if (!sound) return fail(sound.error(), kExitBadInput);
  const auto start = options.start.empty() ? timeOfFiles(options.logs) : timeOf(options.start);
  if (!start) return fail(start.error(), kExitBadInput);
  const std::string part = options.out + ".part";
  int code = kExitBadInput;
  const auto written = writeTo(part, options, *start, code);
  const Status done = written ? Status(Done{}) : Error{written.error()};
  const Status placed = putInPlace(done, part, options.out);
  if (!placed) return fail(placed.error(), interrupted() ? kExitInterrupted : code);
  fmt::print("{}: {} frames in {} messages\n", options.out, written->holds.frames,
             written->messages);
  if (written->holds.lacks.empty()) return kExitDone;
  std::string lacks;
  for (const std::string& what : written->holds.lacks) lacks += (lacks.empty() ? "" : "; ") + what;
  return fail(lacks, kExitBadInput);
}

}  // namespace

void addExport(CommandLine& app, int& code) {
  auto command = app.subcommand(
      "export", "The logs of a match as a file that Foxglove, Lichtblick and Rerun open");
  auto options = std::make_shared<ExportOptions>();
  command.option("LOGS", options->logs, "The logs of one match, at most one of each robot")
      .required();
  command.option("--out", options->out, "The file to write, for example viewer.mcap").required();
  command.option(
      "--start", options->start,
      "When the match began, as 2006-06-14T10:00:00Z (default: the time of the logs' files)");
  command.callback([options, &code] { code = exportMatch(*options); });
}

}  // namespace kelpie::cli
