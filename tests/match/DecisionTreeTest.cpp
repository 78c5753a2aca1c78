// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tools/match/DecisionTree.h"
#include "tools/match/TreePicture.h"

namespace kelpie::match {
namespace {

const behaviour::Rows kRows = {{"0", "", "", "near?", "False"},
                               {"0y", "0", "yes", "ahead?", "False"},
                               {"0yy", "0y", "yes", "kick", "True"},
                               {"0yn", "0y", "no", "turn", "True"},
                               {"0n", "0", "no", "turn", "True"}};

TraceStep step(TraceLayer layer, const std::string& module, const std::string& branch) {
  TraceStep made;
  made.layer = layer;
  made.module.assign(module);
  made.branch.assign(branch);
  return made;
}

Trace leaf(const std::string& module, const std::string& name) {
  Trace trace;
  trace.push_back(step(TraceLayer::role, "attacker", "play"));
  trace.push_back(step(TraceLayer::decision, module, name));
  return trace;
}

// The tree names one leaf, the kick map plays another, and a skill says what it does.
Trace leafByMap(const std::string& module, const std::string& named, const std::string& played) {
  Trace trace = leaf(module, named);
  trace.push_back(step(TraceLayer::decision, "leaf_by_map", played));
  trace.push_back(step(TraceLayer::skill, "grab_dribble", "walk_up"));
  return trace;
}

TEST(DecisionTree, IsMadeFromRows) {
  const auto tree = treeOf(kRows);
  ASSERT_TRUE(tree) << tree.error();
  ASSERT_EQ(tree->nodes.size(), 5U);
  EXPECT_EQ(tree->nodes[0].below, (std::vector<std::size_t>{1, 4}));
  EXPECT_EQ(tree->nodes[3].depth, 2U);
  EXPECT_EQ(tree->nodes[3].edge, "no");
  EXPECT_TRUE(tree->nodes[4].leaf);
}

TEST(DecisionTree, RowsThatAreNoTreeAreRefusedWithTheirNumber) {
  const auto error = [](behaviour::Rows rows) { return treeOf(rows).error(); };
  EXPECT_EQ(error({}), "tree() of main.py: no rows");
  EXPECT_EQ(error({{"0", "", ""}}),
            "tree() of main.py: row 0: not (id, id above, edge, text, is a leaf)");
  EXPECT_EQ(error({kRows[0], kRows[1], kRows[1]}), "tree() of main.py: row 2: a second node '0y'");
  EXPECT_EQ(error({kRows[0], kRows[2]}), "tree() of main.py: row 1: no question '0y' above it");
  EXPECT_EQ(error({kRows[0], kRows[4], {"0nn", "0n", "", "x", "True"}}),
            "tree() of main.py: row 2: no question '0n' above it");
}

TEST(DecisionTree, LeavesAreCountedByNameWhereNoPlaceIsGiven) {
  LeafCounter counter;
  for (const char* name : {"turn", "turn", "kick", "turn"}) counter.take(leaf("tree", name));
  auto tree = *treeOf(kRows);
  EXPECT_FALSE(counter.putInto(tree));
  EXPECT_EQ(tree.nodes[2].count.named.frames, 1U);
  EXPECT_EQ(tree.nodes[3].count.named.frames, 3U);
  EXPECT_EQ(tree.nodes[4].count.named.frames, 3U);
  EXPECT_EQ(tree.nodes[4].count.named.times, 2U);
}

TEST(DecisionTree, LeavesAreCountedAtThePlaceThatIsGiven) {
  LeafCounter counter;
  for (const char* module : {"tree 0yn", "tree 0yn", "tree 0n"}) counter.take(leaf(module, "turn"));
  auto tree = *treeOf(kRows);
  EXPECT_TRUE(counter.putInto(tree));
  EXPECT_EQ(tree.nodes[3].count.named.frames, 2U);
  EXPECT_EQ(tree.nodes[4].count.named.frames, 1U);
  EXPECT_EQ(tree.nodes[1].count.named.frames, 2U) << "a question has those of its leaves";
  EXPECT_EQ(tree.nodes[0].count.named.frames, 3U);
  EXPECT_EQ(counter.byName().at("turn").named.times, 1U) << "the name did not change";
}

TEST(DecisionTree, PlayedIsWhatTheLastDecisionOfAFrameChose) {
  LeafCounter counter;
  counter.take(leaf("tree 0yy", "kick"));
  counter.take(leafByMap("tree 0yy", "kick", "kick_ahead"));
  counter.take(leafByMap("tree 0yy", "kick", "turn"));
  counter.take(leafByMap("tree 0yy", "kick", "kick"));
  counter.take(leaf("tree 0n", "turn"));
  EXPECT_EQ(counter.byName().at("kick").named.frames, 4U);
  EXPECT_EQ(counter.byName().at("kick").named.times, 1U);
  EXPECT_EQ(counter.byName().at("kick").played.frames, 2U);
  EXPECT_EQ(counter.byName().at("kick").played.times, 2U);
  EXPECT_EQ(counter.byName().at("turn").named.frames, 1U);
  EXPECT_EQ(counter.byName().at("turn").played.frames, 2U);
  auto tree = *treeOf(kRows);
  EXPECT_TRUE(counter.putInto(tree));
  EXPECT_EQ(tree.nodes[2].count.named.frames, 4U);
  EXPECT_EQ(tree.nodes[2].count.played.frames, 2U);
  EXPECT_EQ(tree.nodes[2].count.played.times, 2U);
  EXPECT_EQ(tree.nodes[4].count.played.frames, 1U) << "the map's turn came from another leaf";
  EXPECT_EQ(tree.nodes[0].count.played.frames, 3U) << "of five, two were played otherwise";
}

TEST(DecisionTree, ALeafThatOnlyTheMapPlaysIsListed) {
  LeafCounter counter;
  for (int frame = 0; frame < 3; ++frame) counter.take(leafByMap("tree 0yy", "kick", "kick_ahead"));
  EXPECT_EQ(counter.byName().at("kick_ahead").named.frames, 0U);
  EXPECT_EQ(counter.byName().at("kick_ahead").played.frames, 3U);
  EXPECT_EQ(counter.byName().at("kick_ahead").played.times, 1U);
  EXPECT_EQ(counter.byName().at("kick").played.frames, 0U);
}

TEST(DecisionTree, FramesWithoutALeafEndIt) {
  LeafCounter counter;
  counter.take(leaf("tree", "kick"));
  counter.take({});
  counter.take(leaf("treetop", "kick"));
  counter.take(leaf("tree", "kick"));
  EXPECT_EQ(counter.frames(), 4U);
  EXPECT_EQ(counter.decided(), 2U);
  EXPECT_EQ(counter.byName().at("kick").named.times, 2U);
}

TEST(DecisionTree, LeavesOfAnotherTreeCountNowhereInIt) {
  LeafCounter counter;
  counter.take(leaf("tree 0yy", "swim"));
  auto tree = *treeOf(kRows);
  counter.putInto(tree);
  for (const TreeNode& node : tree.nodes) EXPECT_EQ(node.count.named.frames, 0U);
}

TEST(DecisionTree, LongLeafNamesAreFoundAsTheTraceCutThem) {
  const std::string name = "a_name_of_more_than_24_bytes";
  LeafCounter counter;
  counter.take(leaf("tree", name));
  auto tree = *treeOf({{"0", "", "", name, "True"}});
  counter.putInto(tree);
  EXPECT_EQ(tree.nodes[0].count.named.frames, 1U);
}

TEST(DecisionTree, APictureHasALineForEachLeaf) {
  auto tree = *treeOf(kRows);
  const cv::Mat plain = drawTree(tree, 0, {});
  tree.nodes[2].count = {{5, 1}, {3, 1}};
  const cv::Mat counted = drawTree(tree, 10, {"what it is"});
  EXPECT_GT(plain.rows, 3 * 18);
  EXPECT_GT(counted.rows, plain.rows);
  EXPECT_GT(counted.cols, plain.cols) << "the counts stand behind the names";
}

}  // namespace
}  // namespace kelpie::match
