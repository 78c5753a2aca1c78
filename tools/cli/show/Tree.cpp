// SPDX-License-Identifier: Apache-2.0
// The behaviours' decision tree as a picture, with how often a log's robot took each leaf.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "behaviour/Behaviour.h"
#include "tools/cli/Commands.h"
#include "tools/cli/WholeFile.h"
#include "tools/cli/options/Config.h"
#include "tools/match/Decisions.h"
#include "tools/match/TreePicture.h"
#include "tools/picture/PngFile.h"

namespace kelpie::cli {
namespace {

using namespace match;

struct TreeOptions {
  std::string log;
  std::string out;
  std::string pycode = defaultScripts();
};

Expected<DecisionTree> askTree(const std::string& pycode) {
  const Status scripts = checkScripts(pycode);
  if (!scripts) return Error{scripts.error()};
  behaviour::BehaviourState behaviours(pycode);
  const auto rows = behaviours.ask("tree");
  if (!rows) return Error{rows.error()};
  return treeOf(*rows);
}

void printCounts(const LeafCounter& counter, const DecisionTree& tree) {
  std::vector<std::pair<std::string, LeafCount>> leaves(counter.byName().begin(),
                                                        counter.byName().end());
  std::stable_sort(leaves.begin(), leaves.end(),
                   [](const auto& a, const auto& b) { return a.second.frames > b.second.frames; });
  fmt::print("{:>8} {:>6} {:>6}  leaf, of {} frames\n", "frames", "%", "times", counter.frames());
  for (const auto& leaf : leaves) {
    const std::string& name = leaf.first;
    const LeafCount& count = leaf.second;
    const bool known = std::any_of(tree.nodes.begin(), tree.nodes.end(), [&](const TreeNode& n) {
      return n.leaf && decltype(TraceStep::branch)(n.text).view() == name;
    });
    fmt::print("{:8} {:6.1f} {:6}  {}{}\n", count.frames, 100.0 * count.frames / counter.frames(),
               count.times, name, known ? "" : " (not in this tree)");
  }
}

std::vector<std::string> captionOf(const TreeOptions& options, const LeafCounter& counter,
                                   const DecisionLog& log, bool placesKnown) {
  return {fmt::format("{}: {} frames from {:.1f} to {:.1f} s; in {} of them the tree was asked",
                      std::filesystem::path(options.log).filename().string(), counter.frames(),
                      log.first, log.last, counter.decided()),
          "a leaf is the brighter the more frames it took; 'times' is how often it was come to",
          placesKnown ? "" : "counted by a leaf's name: the same wherever that name stands"};
}

int drawOut(const TreeOptions& options, const cv::Mat& picture) {
  const Status drawn = picture::writePng(options.out, picture);
  if (!drawn) return fail(drawn.error(), kExitBadInput);
  fmt::print("{}\n", options.out);
  return kExitDone;
}

int treeWithLog(const TreeOptions& options, DecisionTree& tree) {
  LeafCounter counter;
  constexpr double kEver = std::numeric_limits<double>::infinity();
  const auto log = readDecisions(options.log, {0.0, kEver}, [&](const Decision& decision) {
    counter.take(decision.command.trace);
  });
  if (!log) return fail(log.error(), kExitBadInput);
  if (counter.decided() == 0)
    return fail(options.log + ": holds no decision of the tree", kExitBadInput);
  const bool known = counter.putInto(tree);
  printCounts(counter, tree);
  const int code =
      drawOut(options, drawTree(tree, counter.frames(), captionOf(options, counter, *log, known)));
  if (code != kExitDone || log->lacks.empty()) return code;
  return fail(log->lacks, kExitBadInput);
}

int tree(const TreeOptions& options) {
  if (isDevice(options.out)) return fail(options.out + ": not a plain file", kExitBadInput);
  if (sameFile(options.log, options.out))
    return fail(options.out + ": is the log itself", kExitBadInput);
  auto asked = askTree(options.pycode);
  if (!asked) return fail(asked.error(), kExitBadInput);
  if (!options.log.empty()) return treeWithLog(options, *asked);
  return drawOut(options, drawTree(*asked, 0, {}));
}

}  // namespace

void addTree(CommandLine& app, int& code) {
  auto command = app.subcommand("tree", "A picture of the decision tree, with a log's counts");
  auto options = std::make_shared<TreeOptions>();
  command.option("LOG", options->log, "A log whose leaves are counted");
  command.option("--out", options->out, "The picture to write, a PNG file").required();
  command.option("--pycode", options->pycode, "Behaviours (default: pycode/)")
      .check(existingPath());
  command.callback([options, &code] { code = tree(*options); });
}

}  // namespace kelpie::cli
