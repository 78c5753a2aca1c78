// SPDX-License-Identifier: Apache-2.0
// What the pixels of a view really show: the same scene from the same cameras, without artefacts
// and in colours that tell paint, border and carpet from everything else. To compare
// line points with.
#pragma once

#include <memory>
#include <vector>

#include "tools/experiments/views/View.h"

namespace kelpie::experiments {

class LineTruth {
 public:
  explicit LineTruth(const body::FieldDescription& field);

  void see(const View& view);

  // Share of the pixel, 0..1, that shows it; 0 outside the image.
  double paint(int px, int py) const;
  double border(int px, int py) const;
  double carpet(int px, int py) const;
  // The largest share among the pixel and its eight neighbours.
  double paintNear(PixelPoint pixel) const;

  // From the middle of the nearest painted line, cm.
  double offLine(Point2<Field> place) const;
  // From the border's foot, cm.
  double offBorder(Point2<Field> place) const;

 private:
  body::FieldDescription field_;
  sim::Camera camera_;
  std::unique_ptr<Image> image_;
};

// Middles of the painted segments on vision's grid that a perfect observer would see: at least one
// pixel half painted, carpet on both sides.
struct Crossing {
  PixelPoint middle;
  bool vertical = false;  // the scan's direction
  double length = 0.0;    // px
};
std::vector<Crossing> crossings(const LineTruth& truth);

}  // namespace kelpie::experiments
