// SPDX-License-Identifier: Apache-2.0
#include "tools/match/TreePicture.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tools/match/Draw.h"

namespace kelpie::match {
namespace {

constexpr int kRow = 22;     // px from a leaf to the next
constexpr int kMargin = 14;  // px
constexpr int kPad = 6;      // px from a box to its text
constexpr int kEdge = 54;    // px between columns: lines, and the answers on them
constexpr double kSize = 0.42;
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
const cv::Scalar kPaper(34, 30, 28);
const cv::Scalar kInk(235, 235, 235);
const cv::Scalar kFaint(120, 120, 120);
const cv::Scalar kCold(70, 62, 58);
const cv::Scalar kHot(20, 120, 235);

int widthOf(const std::string& text) {
  return cv::getTextSize(text, kFont, kSize, 1, nullptr).width;
}

class TreeDrawing {
 public:
  TreeDrawing(const DecisionTree& tree, std::uint32_t frames)
      : nodes_(tree.nodes), frames_(frames) {
    words_.reserve(nodes_.size());
    for (const TreeNode& node : nodes_) words_.push_back(wordsOf(node));
    placeColumns();
    placeRows();
  }

  cv::Mat draw(const std::vector<std::string>& caption) const {
    const auto captionHigh = static_cast<int>(caption.size()) * kReasonLine;
    int wide = 2 * kMargin;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      wide = std::max(wide, boxOf(i).br().x + kMargin);
    for (const std::string& line : caption) wide = std::max(wide, widthOf(line) + 2 * kMargin);
    cv::Mat picture(leaves_ * kRow + 2 * kMargin + captionHigh + kMargin, wide, CV_8UC3, kPaper);
    for (std::size_t i = 0; i < nodes_.size(); ++i) drawEdges(picture, i);
    for (std::size_t i = 0; i < nodes_.size(); ++i) drawNode(picture, i);
    drawLines(picture, caption, {kMargin, leaves_ * kRow + 2 * kMargin + kReasonLine}, wide, kSize,
              kInk);
    return picture;
  }

 private:
  std::string wordsOf(const TreeNode& node) const {
    if (!node.leaf || frames_ == 0) return node.text;
    const LeafCount& named = node.count.named;
    if (named.frames == 0) return node.text + "  never";
    const auto counted = [](std::uint32_t count, const char* what) {
      return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
    };
    return fmt::format("{}  {}, {:.1f} %; {}; played in {}", node.text,
                       counted(named.frames, "frame"), 100.0 * named.frames / frames_,
                       counted(named.times, "time"), node.count.played.frames);
  }

  // A column is as wide as the longest question in it; leaves may reach over the next ones, where
  // nothing else stands on their line.
  void placeColumns() {
    std::vector<int> wide;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].depth >= wide.size()) wide.resize(nodes_[i].depth + 1, 0);
      int& max = wide[nodes_[i].depth];
      if (!nodes_[i].leaf) max = std::max(max, widthOf(words_[i]) + 2 * kPad);
    }
    columns_.push_back(kMargin);
    for (const int column : wide) columns_.push_back(columns_.back() + column + kEdge);
  }

  // Leaves in order, a question in the middle of what is below it.
  void placeRows() {
    rows_.resize(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (nodes_[i].below.empty()) rows_[i] = kRow * leaves_++ + kMargin + kRow / 2;
    for (std::size_t i = nodes_.size(); i-- > 0;)
      if (!nodes_[i].below.empty())
        rows_[i] = (rows_[nodes_[i].below.front()] + rows_[nodes_[i].below.back()]) / 2;
  }

  cv::Rect boxOf(std::size_t i) const {
    return {columns_[nodes_[i].depth], rows_[i] - kRow / 2 + 2, widthOf(words_[i]) + 2 * kPad,
            kRow - 4};
  }
  bool taken(std::size_t i) const { return frames_ == 0 || nodes_[i].count.named.frames > 0; }

  void drawEdges(cv::Mat& picture, std::size_t i) const {
    const cv::Rect box = boxOf(i);
    for (const std::size_t below : nodes_[i].below) {
      const cv::Scalar colour = taken(below) ? kInk : kFaint;
      const int left = columns_[nodes_[below].depth] - kEdge;
      const int y = rows_[below];
      cv::line(picture, {box.br().x, rows_[i]}, {left, rows_[i]}, colour);
      cv::line(picture, {left, rows_[i]}, {left + 12, y}, colour, 1, cv::LINE_AA);
      cv::line(picture, {left + 12, y}, {left + kEdge, y}, colour);
      cv::putText(picture, nodes_[below].edge, {left + 17, y - 3}, kFont, 0.36, colour, 1,
                  cv::LINE_AA);
    }
  }

  void drawNode(cv::Mat& picture, std::size_t i) const {
    const cv::Rect box = boxOf(i);
    const double share = frames_ == 0 ? 0.0 : 1.0 * nodes_[i].count.named.frames / frames_;
    const cv::Scalar fill = kCold + (kHot - kCold) * std::sqrt(share);
    cv::rectangle(picture, box, nodes_[i].leaf ? fill : kPaper, cv::FILLED);
    cv::rectangle(picture, box, taken(i) ? kInk : kFaint);
    cv::putText(picture, words_[i], {box.x + kPad, box.br().y - 5}, kFont, kSize,
                taken(i) ? kInk : kFaint, 1, cv::LINE_AA);
  }

  const std::vector<TreeNode>& nodes_;
  std::uint32_t frames_;
  std::vector<std::string> words_;
  std::vector<int> columns_;  // left edges, by depth
  std::vector<int> rows_;     // middles, by node
  int leaves_ = 0;
};

}  // namespace

cv::Mat drawTree(const DecisionTree& tree, std::uint32_t frames,
                 const std::vector<std::string>& caption) {
  return TreeDrawing(tree, frames).draw(caption);
}

}  // namespace kelpie::match
