// SPDX-License-Identifier: Apache-2.0
// The behaviours' decision tree as a table of nodes, from tree() of main.py, with how often a log's
// robot took each leaf. A leaf's name may stand at several places: a trace that names the place
// (the word behind "tree" in its module) counts there, another one at every place with that name.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "behaviour/Rows.h"
#include "robot/core/Expected.h"
#include "robot/core/types/Command.h"

namespace kelpie::match {

struct LeafCount {
  std::uint32_t frames = 0;
  std::uint32_t times = 0;  // it was come to from another leaf, or from none
};

struct TreeNode {
  std::string edge;  // the answer that leads here
  std::string text;  // a question, or a leaf's name
  bool leaf = false;
  std::size_t depth = 0;
  std::vector<std::size_t> below;  // nodes of the table
  LeafCount count;                 // of a question: of all leaves below
};

struct DecisionTree {
  std::vector<TreeNode> nodes;                 // depth first, the first question at the beginning
  std::map<std::string, std::size_t> placeOf;  // by the node's id
};

// Of rows (id, id above, edge, text, "True" for a leaf). An error names the row.
Expected<DecisionTree> treeOf(const behaviour::Rows& rows);

// Follows the traces of consecutive frames.
class LeafCounter {
 public:
  void take(const Trace& trace);

  std::uint32_t frames() const { return frames_; }    // taken
  std::uint32_t decided() const { return decided_; }  // of these, with a leaf
  const std::map<std::string, LeafCount>& byName() const { return byName_; }
  // Into the tree's counts. False where a leaf's place was not given.
  bool putInto(DecisionTree& tree) const;

 private:
  using Leaf = std::pair<std::string, std::string>;  // name and place, which may be empty

  std::uint32_t frames_ = 0;
  std::uint32_t decided_ = 0;
  Leaf last_;
  std::map<Leaf, LeafCount> counts_;
  std::map<std::string, LeafCount> byName_;
};

}  // namespace kelpie::match
