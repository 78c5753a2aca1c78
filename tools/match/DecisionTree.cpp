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

void LeafCounter::take(const Trace& trace) {
  ++frames_;
  Leaf leaf;
  const bool found = std::any_of(trace.begin(), trace.end(), [&](const TraceStep& step) {
    leaf.first = step.branch.view();
    return isTree(step.module.view(), leaf.second);
  });
  if (!found) {
    last_ = {};
    return;
  }
  ++decided_;
  LeafCount once{1, leaf != last_ ? 1U : 0U};
  add(counts_[leaf], once);
  once.times = leaf.first != last_.first ? 1U : 0U;
  add(byName_[leaf.first], once);
  last_ = leaf;
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
