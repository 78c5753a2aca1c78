// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/show/Sheet.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "tools/match/ClassDrawing.h"
#include "tools/match/Draw.h"

namespace kelpie::cli {
namespace {

using namespace match;

constexpr int kScale = 3;
constexpr int kGapPx = 12;
constexpr int kHeading = 26;  // px, of the words above a panel
constexpr int kLine = 20;     // px, of a line of text
constexpr int kLegend = 58;
constexpr std::uint32_t kNamed = 8;          // samples of a blob that gets its number written
constexpr int kWide = kScale * kImageWidth;  // 624
constexpr int kHigh = kScale * kImageHeight;
const cv::Scalar kPaper(34, 30, 28);
const cv::Scalar kInk(235, 235, 235);
const cv::Scalar kFaint(165, 165, 165);
const cv::Scalar kBlob(255, 80, 255);
// Left edges of the table's columns, from the panel's.
constexpr std::array<int, 6> kColumns = {0, 128, 182, 228, 290, 330};
constexpr int kRefusalBelow = 14;   // lines under the top of the words, at least
constexpr int kRefusalWidth = 210;  // px, of a column of reasons
constexpr int kRefusalCount = 175;  // px from a reason to its number

void write(cv::Mat& sheet, const std::string& text, cv::Point where,
           const cv::Scalar& colour = kInk, double size = 0.45) {
  cv::putText(sheet, text, where, cv::FONT_HERSHEY_SIMPLEX, size, colour, 1, cv::LINE_AA);
}

void panel(cv::Mat& sheet, const cv::Mat& picture, cv::Point where, const std::string& heading) {
  write(sheet, heading, where + cv::Point(0, kHeading - 9), kInk, 0.46);
  picture.copyTo(sheet(cv::Rect(where.x, where.y + kHeading, picture.cols, picture.rows)));
}

cv::Mat enlarged(const cv::Mat& picture) {
  cv::Mat large;
  cv::resize(picture, large, {}, kScale, kScale, cv::INTER_NEAREST);
  return large;
}

cv::Mat classPanel(const SheetIn& in) {
  return enlarged(drawClasses(in.input.image, in.vision.tables));
}

void drawBlobs(cv::Mat& picture, const vision::BlobBuffer& blobs) {
  const auto at = [](double v) { return static_cast<int>(kScale * v); };
  for (const auto& blob : blobs) {
    const cv::Rect box(cv::Point(at(blob.box.left), at(blob.box.top)),
                       cv::Point(at(blob.box.right), at(blob.box.bottom)));
    cv::rectangle(picture, box, kBlob, 1);
    if (blob.samples < kNamed) continue;
    const cv::Point where(std::min(box.x, kWide - 30), std::max(box.y - 3, 11));
    const auto text = std::to_string(blob.samples);
    cv::putText(picture, text, where, cv::FONT_HERSHEY_SIMPLEX, 0.4, ink::kBlack, 4, cv::LINE_AA);
    write(picture, text, where, kBlob, 0.4);
  }
}

// Pixels whose class was asked for, over a dark grey image.
cv::Mat lookedPanel(const SheetIn& in) {
  cv::Mat picture(kImageHeight, kImageWidth, CV_8UC3);
  for (std::size_t i = 0; i < kImagePixels; ++i) {
    const auto grey = static_cast<std::uint8_t>(in.input.image.y[i] / 4);
    const std::uint8_t known = in.vision.classes.looked(i);
    picture.ptr<cv::Vec3b>()[i] =
        known == vision::kNotLookedAt ? cv::Vec3b(grey, grey, grey) : inkOfClass(known);
  }
  cv::Mat large = enlarged(picture);
  drawBlobs(large, in.vision.blobs);
  return large;
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, '\t');) cells.push_back(cell);
  return cells;
}

void writeRow(cv::Mat& sheet, const std::string& line, cv::Point where, const cv::Scalar& colour) {
  const auto cells = cellsOf(line);
  for (std::size_t i = 0; i < cells.size() && i < kColumns.size(); ++i)
    write(sheet, cells[i], where + cv::Point(kColumns[i], 0), colour);
}

void writeObjects(cv::Mat& sheet, const SheetText& text, cv::Point where) {
  for (const auto& line : text.frame) {
    write(sheet, line, where);
    where.y += kLine;
  }
  where.y += kLine / 2;
  writeRow(sheet, "found\tcm\tsd\tdeg left\tsd", where, kFaint);
  where.y += kLine;
  for (const auto& line : text.objects) {
    writeRow(sheet, line, where, kInk);
    where.y += kLine;
  }
  if (text.objects.empty()) write(sheet, "nothing", where);
}

// Three columns of reasons under each other, the commonest first.
int linesOfWhy(const SheetIn& in) {
  return in.why.empty() ? 0 : static_cast<int>(in.why.size()) + 2;
}

void writeWhy(cv::Mat& sheet, const SheetIn& in, cv::Point where) {
  if (in.why.empty()) return;
  write(sheet, "what the robot decided, from the player down:", where, kFaint);
  drawLines(sheet, in.why, where + cv::Point(0, kLine), kWide, 0.45, kInk);
}

void writeRefusals(cv::Mat& sheet, const SheetText& text, cv::Point where) {
  write(sheet, "candidates refused, by reason:", where, kFaint);
  const std::size_t high = (text.refusals.size() + 2) / 3;
  for (std::size_t i = 0; i < text.refusals.size(); ++i) {
    const auto column = static_cast<int>(i / high);
    const auto line = static_cast<int>(i % high) + 1;
    const cv::Point at = where + cv::Point(kRefusalWidth * column, kLine * line);
    const auto cells = cellsOf(text.refusals[i]);
    write(sheet, cells[0], at);
    write(sheet, cells[1], at + cv::Point(kRefusalCount, 0));
  }
  if (text.refusals.empty()) write(sheet, "none", where + cv::Point(0, kLine));
}

// Colour patches with the classes' names.
void writeClasses(cv::Mat& sheet, cv::Point where) {
  write(sheet, "classes:", where, kFaint);
  where.x += 80;
  for (std::size_t i = 0; i < vision::kColourClassCount; ++i) {
    const cv::Vec3b c = inkOfClass(static_cast<std::uint8_t>(i));
    const cv::Rect patch(where.x, where.y - 11, 14, 14);
    cv::rectangle(sheet, patch, cv::Scalar(c[0], c[1], c[2]), cv::FILLED);
    cv::rectangle(sheet, patch, kFaint, 1);
    write(sheet, vision::kColourNames[i], where + cv::Point(20, 0));
    where.x += 105;
  }
}

struct Mark {
  const char* name;
  cv::Scalar colour;
  int width;  // px in the legend, words included
};

void writeMarks(cv::Mat& sheet, cv::Point where) {
  write(sheet, "marks:", where, kFaint);
  where.x += 80;
  const std::array<Mark, 3> lines = {{{"horizon", ink::kGrey, 105},
                                      {"field edge", ink::kRed, 120},
                                      {"gap in a goal", ink::kGap, 145}}};
  for (const auto& mark : lines) {
    cv::line(sheet, where + cv::Point(0, -4), where + cv::Point(18, -4), mark.colour, 2);
    write(sheet, mark.name, where + cv::Point(24, 0));
    where.x += mark.width;
  }
  const std::array<Mark, 3> points = {{{"line point", ink::kLine, 105},
                                       {"border point", ink::kBorder, 125},
                                       {"field point", ink::kField, 115}}};
  for (const auto& mark : points) {
    cv::circle(sheet, where + cv::Point(4, -4), 3, mark.colour, cv::FILLED);
    write(sheet, mark.name, where + cv::Point(14, 0));
    where.x += mark.width;
  }
  cv::drawMarker(sheet, where + cv::Point(4, -4), ink::kObstacle, cv::MARKER_TILTED_CROSS, 8, 2);
  write(sheet, "foot of an obstacle", where + cv::Point(14, 0));
}

// Lines of text above the refusals, and of all.
int linesAbove(const SheetText& text) {
  const auto lines = static_cast<int>(text.frame.size() + text.objects.size()) + 3;
  return std::max(lines, kRefusalBelow);
}

int linesIn(const SheetText& text) {
  return linesAbove(text) + static_cast<int>(text.refusals.size() + 2) / 3 + 2;
}

}  // namespace

cv::Mat drawSheet(const SheetIn& in) {
  const SheetText text = sheetText(in);
  const int right = kWide + 2 * kGapPx;
  const int top = kHeading + kGapPx;
  const int second = top + kHeading + kHigh + kGapPx;
  const int textHigh = std::max(kHigh, kLine * (linesIn(text) + linesOfWhy(in)));
  const int legend = second + kHeading + textHigh + kGapPx;
  cv::Mat sheet(legend + kLegend, right + kWide + kGapPx, CV_8UC3, kPaper);
  write(sheet, in.title, {kGapPx, kHeading}, kInk, 0.55);
  panel(sheet, drawCamera(in.input, in.output, kScale), {kGapPx, top},
        "the image; boxes, circle and marks: what vision found");
  panel(sheet, classPanel(in), {right, top}, "the class of every pixel, by the colour table");
  panel(sheet, lookedPanel(in), {kGapPx, second},
        "coloured: pixels whose class vision asked for; boxes: blobs, with their samples");
  const cv::Point words(right, second + kHeading + kLine);
  writeObjects(sheet, text, words);
  writeRefusals(sheet, text, words + cv::Point(0, kLine * linesAbove(text)));
  writeWhy(sheet, in, words + cv::Point(0, kLine * linesIn(text)));
  writeClasses(sheet, {kGapPx, legend + 14});
  writeMarks(sheet, {kGapPx, legend + 38});
  return sheet;
}

}  // namespace kelpie::cli
