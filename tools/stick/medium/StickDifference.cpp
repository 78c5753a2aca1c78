// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/medium/StickDifference.h"

#include <fmt/core.h>

#include <memory>

#include "robot/core/fields/FieldCheck.h"
#include "robot/stick/StdioFiles.h"
#include "robot/stick/StickReader.h"
#include "tools/stick/Programs.h"
#include "tools/stick/medium/FormerFiles.h"

namespace kelpie::stick {
namespace {

std::string fileLine(const TreeFile& file, const std::string& root, const StickTree& former) {
  const auto old = readWhole(root + "/" + file.path);
  if (!old) return fmt::format("new      {} ({} bytes)", file.path, file.bytes.size());
  if (*old == file.bytes) return fmt::format("same     {}", file.path);
  const TreeFile* kept = findFile(former, file.path);
  const bool foreign = kept != nullptr && haveAnotherProgram({*kept});
  const char* whose = foreign ? ", another program's" : kept ? ", its owner's, which is kept" : "";
  return fmt::format("{}  {} ({} bytes, was {}{})", foreign ? "foreign" : "changed", file.path,
                     file.bytes.size(), old->size(), whose);
}

std::string configLine(const agent::AgentConfig& config, const std::string& root) {
  StdioFiles files(root.c_str());
  const auto reader = std::make_unique<StickReader>(files);
  const auto old = std::make_unique<agent::AgentConfig>();
  const StickVerdict verdict = reader->load(*old);
  if (!verdict.good())
    return "as it is the robot refuses it: " + std::string(lineOf(verdict).view());
  std::string where;
  if (!firstDifference(*old, config, &where)) return "the configuration is the same";
  return "the configuration differs, first in " + where;
}

}  // namespace

std::vector<std::string> differenceLines(const StickTree& tree, const agent::AgentConfig& config,
                                         const std::string& root) {
  std::vector<std::string> lines;
  const auto former = formerFiles(tree, root);
  for (const auto& file : tree)
    lines.push_back(fileLine(file, root, former ? *former : StickTree{}));
  if (!former) lines.push_back(former.error());
  lines.push_back(configLine(config, root));
  return lines;
}

}  // namespace kelpie::stick
