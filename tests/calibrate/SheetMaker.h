// SPDX-License-Identifier: Apache-2.0
// Images of evenly coloured sheets under a given ring effect, with noise of 2 grey levels.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "robot/core/Random.h"
#include "tools/calibrate/ring/Sheets.h"
#include "vision/colour/RingTable.h"

namespace kelpie::calibrate {

struct Paper {
  double y = 0.0;
  double cr = 0.0;
  double cb = 0.0;
};
constexpr std::array<Paper, 4> kPapers = {
    {{82, 121, 167}, {77, 103, 97}, {189, 124, 129}, {120, 160, 61}}};

inline Image sheetImage(const Paper& paper, const vision::RingModel& model, Random& random) {
  Image image;
  const std::array<double, 3> colour{paper.y, paper.cr, paper.cb};
  const std::array<Image::Plane*, 3> planes{&image.y, &image.cr, &image.cb};
  for (std::size_t c = 0; c < 3; ++c)
    for (int py = 0; py < kImageHeight; ++py)
      for (int px = 0; px < kImageWidth; ++px) {
        const auto& centre = model.centre[c];
        const double d = std::hypot(px + 0.5 - centre.column, py + 0.5 - centre.row);
        const double value = ringDistort(model.channel[c], colour[c], d) + random.gaussian(0, 2);
        (*planes[c])[Image::at(px, py)] =
            static_cast<std::uint8_t>(maths::clamp(value + 0.5, 0.0, 255.0));
      }
  return image;
}

inline std::vector<Sheet> sheetsOf(const std::vector<Paper>& papers,
                                   const vision::RingModel& model) {
  Random random(11);
  std::vector<Sheet> sheets;
  for (const auto& paper : papers)
    sheets.push_back(
        wholeSheet("sheet " + std::to_string(sheets.size()), sheetImage(paper, model, random), 3));
  return sheets;
}

inline std::vector<Paper> allPapers() { return {kPapers.begin(), kPapers.end()}; }

}  // namespace kelpie::calibrate
