// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/ring/RingJudge.h"

#include <algorithm>
#include <cmath>

namespace kelpie::calibrate {
namespace {

constexpr double kClearlyWorse = 0.2;  // grey levels; twice the noise of the figures
constexpr Centre kImageCentre = {kImageWidth / 2.0, kImageHeight / 2.0};

// The unevenness of one sheet in one channel; nothing when it is too small to fill a ring.
double unevennessOf(const Sheet& sheet, std::size_t channel, const vision::RingTable& table,
                    const vision::RingDistances& distances) {
  std::vector<double> values;
  double sum = 0.0;
  for (const SheetPixel& pixel : sheet.pixels) {
    const Yuv seen = table(pixel.value, distances(pixel.px, pixel.py, table.centre));
    values.push_back(channelOf(seen, channel));
    sum += values.back();
  }
  const double mean = sum / static_cast<double>(values.size());
  RingMeans rings;
  for (std::size_t i = 0; i < values.size(); ++i)
    rings.add(distanceTo(kImageCentre, sheet.pixels[i]), values[i] - mean);
  return rings.rms();
}

}  // namespace

Levels unevenness(const std::vector<Sheet>& sheets, const vision::RingTable& table) {
  const vision::RingDistances distances;
  Levels levels{};
  for (std::size_t c = 0; c < levels.size(); ++c) {
    double sum = 0.0;
    for (const Sheet& sheet : sheets) {
      const double level = unevennessOf(sheet, c, table, distances);
      sum += level * level;
    }
    levels[c] = sheets.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(sheets.size()));
  }
  return levels;
}

RingVerdict compareUnevenness(const std::vector<Sheet>& sheets, const vision::RingTable& learnt) {
  return {unevenness(sheets, learnt),
          unevenness(sheets, vision::buildRingTable(vision::ringModel2006())),
          unevenness(sheets, vision::buildRingTable({}))};
}

bool isWorse(const RingVerdict& verdict, std::size_t channel) {
  const double best = std::min(verdict.published[channel], verdict.none[channel]);
  return verdict.learnt[channel] > best + kClearlyWorse;
}

}  // namespace kelpie::calibrate
