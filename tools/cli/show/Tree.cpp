// SPDX-License-Identifier: Apache-2.0
// The behaviours' decision tree as a picture, with how often in a log the tree named
// each leaf and how often it was played.
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

std::string wordsOf(const LeafCount& count, std::uint32_t frames) {
  return fmt::format("{:8} {:6.1f} {:6}", count.frames, 100.0 * count.frames / frames, count.times);
}

void printCounts(const LeafCounter& counter, const DecisionTree& tree) {
  std::vector<std::pair<std::string, LeafCounts>> leaves(counter.byName().begin(),
                                                         counter.byName().end());
  std::stable_sort(leaves.begin(), leaves.end(), [](const auto& a, const auto& b) {
    return a.second.played.frames > b.second.played.frames;
  });
  fmt::print("{:>22} {:>23}\n", "the tree named", "played");
  for (int column = 0; column < 2; ++column)
    fmt::print("{:>8} {:>6} {:>6} ", "frames", "%", "times");
  fmt::print(" leaf, of {} frames\n", counter.frames());
  for (const auto& leaf : leaves) {
    const std::string& name = leaf.first;
    const LeafCounts& count = leaf.second;
    const bool known = std::any_of(tree.nodes.begin(), tree.nodes.end(), [&](const TreeNode& n) {
      return n.leaf && decltype(TraceStep::branch)(n.text).view() == name;
    });
    fmt::print("{} {}  {}{}\n", wordsOf(count.named, counter.frames()),
               wordsOf(count.played, counter.frames()), name, known ? "" : " (not in this tree)");
  }
}

std::vector<std::string> captionOf(const TreeOptions& options, const LeafCounter& counter,
                                   const DecisionLog& log, bool placesKnown) {
  return {fmt::format("{}: {} frames from {:.1f} to {:.1f} s; in {} of them the tree was asked",
                      std::filesystem::path(options.log).filename().string(), counter.frames(),
                      log.first, log.last, counter.decided()),
          "a leaf is the brighter the more frames the tree named it in; 'times': it was come to",
          "'played in': of these frames, where no later decision (leaf_by_map) chose another",
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
