// SPDX-License-Identifier: Apache-2.0
// The behaviours' decision tree as a table of nodes, from tree() of main.py, with how often in a
// log the tree named each leaf and how often that leaf was played: a decision that follows the
// tree's in a frame (the kick map's) may have chosen another. A leaf's name may stand at several
// places: a trace that names the place (the word behind "tree" in its module) counts there, another
// one at every place with that name.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
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

struct LeafCounts {
  LeafCount named;   // by the tree
  LeafCount played;  // at a place of the tree: of the frames in which it was named there
};

struct TreeNode {
  std::string edge;  // the answer that leads here
  std::string text;  // a question, or a leaf's name
  bool leaf = false;
  std::size_t depth = 0;
  std::vector<std::size_t> below;  // nodes of the table
  LeafCounts count;                // of a question: of all leaves below
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
  // Those that the tree named, and those that were played, whether it has them or not.
  const std::map<std::string, LeafCounts>& byName() const { return byName_; }
  // Into the tree's counts. False where a leaf's place was not given.
  bool putInto(DecisionTree& tree) const;

 private:
  using Leaf = std::pair<std::string, std::string>;  // name and place, which may be empty
  // What a frame's trace tells.
  struct Choice {
    Leaf named;
    std::string played;
  };
  static std::optional<Choice> choiceOf(const Trace& trace);
  void countNamed(const Choice& choice);
  void countPlayed(const Choice& choice);

  std::uint32_t frames_ = 0;
  std::uint32_t decided_ = 0;
  std::optional<Choice> last_;  // of the frame before
  std::map<Leaf, LeafCounts> counts_;
  std::map<std::string, LeafCounts> byName_;
};

}  // namespace kelpie::match
