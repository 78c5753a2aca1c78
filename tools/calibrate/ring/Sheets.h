// SPDX-License-Identifier: Apache-2.0
// Sheets: pixels of one surface of one colour in one image, which is what the ring effect is
// learnt from (thesis 2006 figure 2.3 shows four), and how even such a surface looks.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "robot/core/types/Image.h"

namespace kelpie::calibrate {

struct SheetPixel {
  int px = 0;
  int py = 0;
  Yuv value;
};

struct Sheet {
  std::string name;
  std::vector<SheetPixel> pixels;
};

using Centre = std::array<double, 2>;  // column, row; pixel i lies between i and i + 1

// Every `step`-th pixel in x and y inside the unusable rim.
Sheet wholeSheet(const std::string& name, const Image& image, int step);
// The surface that covers most of the image by its chroma after the published correction: for
// scenes that are no sheets.
Sheet dominantSurface(const std::string& name, const Image& image, int step);

std::uint8_t channelOf(Yuv value, std::size_t channel);  // 0 Y, 1 Cr, 2 Cb
double distanceTo(const Centre& centre, const SheetPixel& pixel);

// Mean of values by distance in rings 12 px wide.
class RingMeans {
 public:
  void add(double distance, double value, double weight = 1.0);
  double rms() const;     // of the rings' means
  double spread() const;  // largest less smallest

 private:
  static constexpr std::size_t kRings = 13;
  std::vector<double> means() const;
  std::array<double, kRings> sum_{};
  std::array<double, kRings> weight_{};
};

}  // namespace kelpie::calibrate
