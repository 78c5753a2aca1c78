// SPDX-License-Identifier: Apache-2.0
// A picture that is drawn with smooth lines and set type, by Cairo and Pango, in pixels from its
// upper left corner. Text is never wider than it is allowed to be: it is broken into lines, and
// what does not fit ends with an ellipsis. Needs one font of any kind; create() says where none is.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie::picture {

// Shares of red, green and blue, and how much of what is below it covers.
struct Ink {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;
  double cover = 1.0;

  Ink faded(double share) const { return {red, green, blue, cover * share}; }
};

struct Spot {
  double x = 0.0;
  double y = 0.0;
};

struct Frame {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
};

enum class Align { left, centre, right };

struct Type {
  double size = 14.0;  // px
  Ink ink;
  bool bold = false;
  Align align = Align::left;
  int lines = 1;  // at most
};

class Canvas {
 public:
  static Expected<Canvas> create(cv::Size size, const Ink& ground);
  // Draws over a picture of blue, green and red.
  static Expected<Canvas> over(const cv::Mat& picture);
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;
  ~Canvas();

  cv::Size size() const;
  cv::Mat picture() const;  // blue, green, red

  void box(const Frame& frame, const Ink& ink, double corner = 0.0);
  void outline(const Frame& frame, const Ink& ink, double width, double corner = 0.0);
  void disc(Spot middle, double radius, const Ink& ink);
  void ring(Spot middle, double radius, const Ink& ink, double width);
  // Turned by so many radians, clockwise.
  void ellipse(Spot middle, Spot radii, double turn, const Ink& ink, double width);
  void line(const std::vector<Spot>& spots, const Ink& ink, double width);
  void dashes(const std::vector<Spot>& spots, const Ink& ink, double width, double dash);
  void shape(const std::vector<Spot>& corners, const Ink& ink);
  void arrow(Spot from, Spot to, const Ink& ink, double width);
  // The picture, stretched into the frame; `smooth` = false keeps its pixels as squares.
  void paste(const cv::Mat& picture, const Frame& frame, bool smooth = true);
  // What is drawn until uncut() stays within the frame.
  void cut(const Frame& frame, double corner = 0.0);
  void uncut();

  // Where x, y is the upper left corner of the text, or its middle or right end as it is aligned.
  // 0 as the width: as wide as it is. Gives the size that it takes.
  cv::Size2d text(Spot where, const std::string& words, const Type& type, double width = 0.0);
  // The same with a dark seam, to be read on anything.
  cv::Size2d label(Spot where, const std::string& words, const Type& type, double width = 0.0);
  cv::Size2d measure(const std::string& words, const Type& type, double width = 0.0) const;

 private:
  struct Surface;
  explicit Canvas(std::unique_ptr<Surface> surface);
  std::unique_ptr<Surface> surface_;
};

}  // namespace kelpie::picture
