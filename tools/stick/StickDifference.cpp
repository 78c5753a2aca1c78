// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/StickDifference.h"

#include <fmt/core.h>

#include <memory>

#include "robot/core/FieldCheck.h"
#include "robot/stick/StdioFiles.h"
#include "robot/stick/StickReader.h"
#include "tools/stick/Programs.h"

namespace kelpie::stick {
namespace {

std::string fileLine(const TreeFile& file, const std::string& root) {
  const auto old = readWhole(root + "/" + file.path);
  if (!old) return fmt::format("new      {} ({} bytes)", file.path, file.bytes.size());
  if (*old == file.bytes) return fmt::format("same     {}", file.path);
  return fmt::format("changed  {} ({} bytes, was {})", file.path, file.bytes.size(), old->size());
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
  for (const auto& file : tree) lines.push_back(fileLine(file, root));
  lines.push_back(configLine(config, root));
  return lines;
}

}  // namespace kelpie::stick
