// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/Export.h"

#include <algorithm>
#include <deque>
#include <filesystem>

#include "tools/cli/Process.h"
#include "tools/cli/Progress.h"
#include "tools/cli/log/Logs.h"
#include "tools/viewer/LogMessages.h"

namespace kelpie::viewer {
namespace {

namespace fs = std::filesystem;

// Reads one log ahead by one message.
struct Source {
  std::string path;
  LogReader reader;
  LogMessages messages;
  LogMessage message;
  bool more = false;

  void advance() { more = reader.next(message); }
};
using Sources = std::deque<Source>;  // a LogMessages stays where it is

Status openAll(const std::vector<std::string>& logs, SharedWorld& world, Sources& sources) {
  for (const std::string& path : logs) {
    std::error_code error;
    if (fs::is_directory(path, error))
      return Error{path + ": is a folder; name its logs, as " +
                   (fs::path(path) / "*.mcap").string()};
    auto reader = LogReader::open(path);
    if (!reader) return Error{reader.error()};
    const std::size_t number = sources.size();
    sources.push_back({path, std::move(*reader), LogMessages(number, world), {}, false});
    sources.back().advance();
  }
  return Done{};
}

// The source whose next message is the oldest; the first of equals.
Source* oldest(Sources& sources) {
  Source* best = nullptr;
  for (Source& source : sources)
    if (source.more && (best == nullptr || source.message.time < best->message.time))
      best = &source;
  return best;
}

Status sendAll(Sources& sources, const ViewerFile& file) {
  cli::Progress progress("export", "MB");
  std::uint64_t bytes = 0;
  std::error_code ignored;
  for (const Source& source : sources) bytes += fs::file_size(source.path, ignored);
  const auto megabytes = [](std::uint64_t b) { return static_cast<std::size_t>(b / 1000000); };
  for (Source* next = oldest(sources); next != nullptr; next = oldest(sources)) {
    const Status taken = next->messages.take(next->message);
    if (!taken) return Error{next->path + ": " + taken.error()};
    if (!file.status()) return file.status();
    if (cli::interrupted()) return Error{"interrupted"};
    next->advance();
    std::uint64_t read = 0;
    for (const Source& source : sources) read += source.reader.offset();
    progress(megabytes(read), megabytes(bytes));
  }
  return Done{};
}

std::string lacksOf(const Source& source) {
  const std::size_t damaged = source.messages.damaged();
  const std::string lacks = source.reader.lacks();
  if (damaged == 0) return lacks;
  return lacks + (lacks.empty() ? "" : "; ") + std::to_string(damaged) +
         " damaged messages left out";
}

Expected<Exported> gather(const Sources& sources) {
  Exported found;
  std::size_t truths = 0;
  for (const Source& source : sources) {
    if (!source.reader.status()) return Error{source.reader.status().error()};
    cli::tellNotes(source.reader);
    const std::string lacks = lacksOf(source);
    if (!lacks.empty()) found.lacks.push_back(source.path + ": " + lacks);
    found.frames += source.messages.frames();
    truths += source.messages.truths();
  }
  if (found.frames + truths == 0) {
    const std::string rest = found.lacks.empty() ? "" : " (" + found.lacks.front() + ")";
    return Error{sources.front().path + ": holds no frames with outputs to show" + rest};
  }
  return found;
}

}  // namespace

Expected<Exported> exportLogs(const std::vector<std::string>& logs, TimeUs start,
                              ViewerFile& file) {
  SharedWorld world(start, file);
  Sources sources;
  const Status opened = openAll(logs, world, sources);
  if (!opened) return Error{opened.error()};
  const Status sent = sendAll(sources, file);
  if (!sent) return Error{sent.error()};
  auto found = gather(sources);
  if (!found) return found;
  // The world's own log says no field: most matches are played on this one.
  if (!world.messages().fieldKnown()) world.messages().field({}, *body::fieldDescription("2006"));
  return found;
}

}  // namespace kelpie::viewer
