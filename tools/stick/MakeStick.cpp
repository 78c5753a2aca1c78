// SPDX-License-Identifier: Apache-2.0
#include "tools/stick/MakeStick.h"

#include <fmt/core.h>

#include <memory>

#include "robot/core/fields/FieldCheck.h"
#include "robot/stick/StickReader.h"
#include "tools/stick/StickWriter.h"
#include "tools/stick/SystemFiles.h"

namespace kelpie::stick {
namespace {

Status checkTree(const StickTree& tree) {
  for (const auto& file : tree)
    if (!isShortName(file.path)) return Error{file.path + ": not a name of 8.3 in upper case"};
  const std::size_t bytes = bytesOf(tree);
  if (bytes <= kLargestTree) return Done{};
  return Error{fmt::format("the stick's files have {} bytes; {} at most", bytes, kLargestTree)};
}

}  // namespace

Status verifyStick(StickFiles& files, const agent::AgentConfig& config) {
  const auto reader = std::make_unique<StickReader>(files);
  const auto loaded = std::make_unique<agent::AgentConfig>();
  const StickVerdict verdict = reader->load(*loaded);
  if (!verdict.good()) return Error{std::string(lineOf(verdict).view())};
  std::string where;
  if (!firstDifference(*loaded, config, &where)) return Done{};
  return Error{std::string(kStickPath) + ": read back with " + where};
}

Expected<StickTree> makeTree(const agent::AgentConfig& config, const StickContents& contents) {
  std::string why;
  if (!verify(config, &why)) return Error{"the configuration's " + why};
  StickTree tree = systemFiles();
  if (contents.relaxedJams) tree.push_back(relaxedJams());
  if (!contents.wlan.empty()) tree.push_back({kWlanPath, contents.wlan});
  if (!contents.object.empty()) tree.push_back({kObjectPath, contents.object});
  tree.push_back({kScriptsPath, contents.behaviours});
  tree.push_back({kStickPath, stickBinary(config, tree)});
  Status good = checkTree(tree);
  TreeFiles files(tree);
  if (good) good = verifyStick(files, config);
  if (!good) return Error{good.error()};
  return tree;
}

}  // namespace kelpie::stick
