// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/LogShelf.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "robot/core/log/LogIndex.h"
#include "robot/core/log/LogReader.h"
#include "tools/cli/log/Logs.h"
#include "tools/live/LogsOf.h"

namespace kelpie::studio {
namespace {

namespace fs = std::filesystem;

// Whether its summary says where its chunks are.
bool isIndexed(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::error_code error;
  const std::vector<std::uint8_t> summary = readSummary(file, fs::file_size(path, error));
  mcap::ContentReader content(summary.data(), summary.size());
  while (content.left() > 0 && content.good())
    if (content.record().op == mcap::Op::chunkIndex) return true;
  return false;
}

std::uint64_t sizeOf(const std::string& path) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  return error ? 0 : size;
}

}  // namespace

Status LogShelf::add(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return addFolder(path);
  const auto reader = LogReader::open(path);
  if (!reader) return Error{reader.error()};
  if (!isIndexed(path)) return addWhole(path);
  logs_.push_back({fs::path(path).filename().string(), path, sizeOf(path), {}});
  return Done{};
}

Status LogShelf::addWhole(const std::string& path) {
  const std::string copy = temporary("log-" + std::to_string(copies_++) + ".mcap");
  const auto joined = cli::mergeLogs({path}, copy);
  if (!joined) return Error{joined.error()};
  ShelvedLog log{fs::path(path).filename().string(), copy, sizeOf(copy), joined->lacks};
  if (joined->messages == 0) return Error{path + ": holds nothing that can be shown"};
  if (joined->damaged > 0)
    log.notes.push_back(std::to_string(joined->damaged) + " damaged messages are left out");
  logs_.push_back(std::move(log));
  return Done{};
}

Status LogShelf::addFolder(const std::string& folder) {
  Status all = Done{};
  for (const std::string& path : live::logsOf(folder)) {
    const Status added = add(path);
    if (all && !added) all = added;
  }
  return all;
}

Status LogShelf::addMatch(const std::string& folder) {
  const std::string parts = (fs::path(folder) / "playing").string();
  std::error_code error;
  return addFolder(fs::is_directory(parts, error) ? parts : folder);
}

}  // namespace kelpie::studio
