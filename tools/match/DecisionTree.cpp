// SPDX-License-Identifier: Apache-2.0
#include "tools/match/DecisionTree.h"

#include <algorithm>

namespace kelpie::match {
namespace {

constexpr std::size_t kCells = 5;
constexpr std::string_view kModule = "tree";  // of the trace's step that names a leaf

Error wrongRow(std::size_t row, const std::string& what) {
  return {"tree() of main.py: row " + std::to_string(row) + ": " + what};
}

// The place in the tree that a module of a trace names; false where it is another module.
bool isTree(std::string_view module, std::string& place) {
  const std::string_view rest = module.substr(std::min(module.size(), kModule.size()));
  if (module.substr(0, kModule.size()) != kModule || (!rest.empty() && rest[0] != ' '))
    return false;
  place = rest.substr(std::min<std::size_t>(rest.size(), 1));
  return true;
}

// A name as a trace can hold it.
std::string asTraced(const std::string& name) {
  return std::string(decltype(TraceStep::branch)(name).view());
}

void add(LeafCount& sum, const LeafCount& more) {
  sum.frames += more.frames;
  sum.times += more.times;
}

void add(LeafCounts& sum, const LeafCounts& more) {
  add(sum.named, more.named);
  add(sum.played, more.played);
}

}  // namespace

Expected<DecisionTree> treeOf(const behaviour::Rows& rows) {
  DecisionTree tree;
  for (const auto& row : rows) {
    const std::size_t place = tree.nodes.size();
    if (row.size() != kCells) return wrongRow(place, "not (id, id above, edge, text, is a leaf)");
    TreeNode node;
    node.edge = row[2];
    node.text = row[3];
    node.leaf = row[4] == "True";
    if (!tree.placeOf.emplace(row[0], place).second)
      return wrongRow(place, "a second node '" + row[0] + "'");
    if (place > 0) {
      const auto above = tree.placeOf.find(row[1]);
      if (above == tree.placeOf.end() || above->second == place || tree.nodes[above->second].leaf)
        return wrongRow(place, "no question '" + row[1] + "' above it");
      node.depth = tree.nodes[above->second].depth + 1;
      tree.nodes[above->second].below.push_back(place);
    }
    tree.nodes.push_back(std::move(node));
  }
  if (tree.nodes.empty()) return Error{"tree() of main.py: no rows"};
  return tree;
}

// Played is what the last decision of the frame chose, from the tree's on.
std::optional<LeafCounter::Choice> LeafCounter::choiceOf(const Trace& trace) {
  std::optional<Choice> choice;
  for (const TraceStep& step : trace) {
    const std::string branch(step.branch.view());
    std::string place;
    if (!choice && isTree(step.module.view(), place))
      choice = Choice{{branch, place}, branch};
    else if (choice && step.layer == TraceLayer::decision)
      choice->played = branch;
  }
  return choice;
}

void LeafCounter::countNamed(const Choice& choice) {
  LeafCount once{1, !last_ || choice.named != last_->named ? 1U : 0U};
  add(counts_[choice.named].named, once);
  once.times = !last_ || choice.named.first != last_->named.first ? 1U : 0U;
  add(byName_[choice.named.first].named, once);
}

void LeafCounter::countPlayed(const Choice& choice) {
  LeafCount once{1, !last_ || choice.played != last_->played ? 1U : 0U};
  add(byName_[choice.played].played, once);
  if (choice.played != choice.named.first) return;
  once.times = once.times == 1 || choice.named != last_->named ? 1U : 0U;
  add(counts_[choice.named].played, once);
}

void LeafCounter::take(const Trace& trace) {
  ++frames_;
  const std::optional<Choice> choice = choiceOf(trace);
  if (choice) {
    ++decided_;
    countNamed(*choice);
    countPlayed(*choice);
  }
  last_ = choice;
}

bool LeafCounter::putInto(DecisionTree& tree) const {
  bool allKnown = true;
  for (const auto& [leaf, count] : counts_) {
    const auto found = tree.placeOf.find(leaf.second);
    const bool known =
        found != tree.placeOf.end() && asTraced(tree.nodes[found->second].text) == leaf.first;
    allKnown = allKnown && known;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      const bool here = known ? i == found->second : asTraced(tree.nodes[i].text) == leaf.first;
      if (here && tree.nodes[i].leaf) add(tree.nodes[i].count, count);
    }
  }
  // Those below come later in the table.
  for (std::size_t i = tree.nodes.size(); i-- > 0;)
    for (const std::size_t below : tree.nodes[i].below)
      add(tree.nodes[i].count, tree.nodes[below].count);
  return allKnown;
}

}  // namespace kelpie::match
