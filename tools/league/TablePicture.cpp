// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tools/league/Table.h"
#include "tools/match/Draw.h"
#include "tools/picture/PngFile.h"

namespace kelpie::league {
namespace {

constexpr int kRow = 24;       // px from a line to the next
constexpr int kMargin = 18;    // px
constexpr int kGap = 22;       // px between columns
constexpr int kBar = 220;      // px of the drawn intervals
constexpr int kMaxRows = 400;  // of a table: more make no picture to look at
constexpr std::size_t kMaxLines = 12;
constexpr double kSize = 0.45;
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
const cv::Scalar kPaper(255, 255, 255);
const cv::Scalar kFaint(215, 215, 215);

int widthOf(const std::string& text) {
  return cv::getTextSize(text, kFont, kSize, 1, nullptr).width;
}

std::vector<int> widthsOf(const Table& table) {
  std::vector<int> widths;
  for (std::size_t column = 0; column < table.heads.size(); ++column) {
    int width = widthOf(table.heads[column]);
    for (const TableRow& row : table.rows) width = std::max(width, widthOf(row.cells[column]));
    widths.push_back(width);
  }
  return widths;
}

// A league may have any number of void matches.
std::vector<std::string> firstOf(std::vector<std::string> lines) {
  if (lines.size() <= kMaxLines) return lines;
  lines.resize(kMaxLines);
  lines.back() = "... more in table.txt";
  return lines;
}

class TableDrawing {
 public:
  explicit TableDrawing(Table table) : table_(std::move(table)), widths_(widthsOf(table_)) {
    if (table_.rows.size() > kMaxRows) table_.rows.resize(kMaxRows);
    for (const TableRow& row : table_.rows)
      if (row.interval)
        reach_ = std::max({reach_, std::fabs(row.interval->low), std::fabs(row.interval->high)});
  }

  int width() const {
    int wide = 2 * kMargin + kBar;
    for (const int width : widths_) wide += width + kGap;
    return wide;
  }
  int height() const { return kRow * (static_cast<int>(table_.rows.size()) + 3); }

  // From `top` downwards.
  void draw(cv::Mat& picture, int top) const {
    int y = top + kRow;
    cv::putText(picture, table_.title, {kMargin, y}, kFont, 1.2 * kSize, match::ink::kBlack, 1,
                cv::LINE_AA);
    y += kRow;
    drawCells(picture, table_.heads, y);
    for (const TableRow& row : table_.rows) {
      cv::line(picture, {kMargin, y + 7}, {picture.cols - kMargin, y + 7}, kFaint);
      y += kRow;
      drawCells(picture, row.cells, y);
      if (row.interval) drawBar(picture, row, y - 5);
    }
  }

 private:
  void drawCells(cv::Mat& picture, const std::vector<std::string>& cells, int y) const {
    int x = kMargin;
    for (std::size_t column = 0; column < cells.size(); ++column) {
      const int indent = column < table_.names ? 0 : widths_[column] - widthOf(cells[column]);
      cv::putText(picture, cells[column], {x + indent, y}, kFont, kSize, match::ink::kBlack, 1,
                  cv::LINE_AA);
      x += widths_[column] + kGap;
    }
  }

  // The interval as a bar, its mean as a dot, and the line of no difference.
  void drawBar(cv::Mat& picture, const TableRow& row, int y) const {
    const int left = width() - kMargin - kBar;
    const auto at = [&](double goals) {
      return cv::Point(left + static_cast<int>(std::lround(kBar * (0.5 + 0.47 * goals / reach_))),
                       y);
    };
    const cv::Point zero = at(0.0);
    cv::line(picture, {zero.x, y - kRow / 2}, {zero.x, y + kRow / 2}, match::ink::kGrey);
    cv::line(picture, at(row.interval->low), at(row.interval->high), match::ink::kBlue, 3,
             cv::LINE_AA);
    cv::circle(picture, at(row.mean), 4, match::ink::kBlue, cv::FILLED, cv::LINE_AA);
  }

  Table table_;
  std::vector<int> widths_;  // px, by column
  double reach_ = 0.5;       // goals a match at the bars' ends
};

}  // namespace

Status drawTables(const Standings& standings, const std::string& pngPath) {
  const TableDrawing sides(sideTable(standings));
  const TableDrawing pairs(pairTable(standings));
  const auto summary = firstOf(summaryOf(standings));
  const auto notes = notesOf(standings);
  const auto lines = static_cast<int>(summary.size() + notes.size());
  const int wide = std::max({sides.width(), pairs.width(), 900});
  cv::Mat picture(sides.height() + pairs.height() + lines * match::kReasonLine + 3 * kMargin, wide,
                  CV_8UC3, kPaper);
  int y = kMargin + match::kReasonLine / 2;
  match::drawLines(picture, summary, {kMargin, y}, wide - 2 * kMargin, kSize, match::ink::kBlack);
  y += static_cast<int>(summary.size()) * match::kReasonLine;
  sides.draw(picture, y);
  y += sides.height();
  pairs.draw(picture, y);
  y += pairs.height() + match::kReasonLine / 2;
  match::drawLines(picture, notes, {kMargin, y}, wide - 2 * kMargin, kSize, match::ink::kBlack);
  return picture::writePng(pngPath, picture);
}

}  // namespace kelpie::league
