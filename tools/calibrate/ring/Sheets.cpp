// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/ring/Sheets.h"

#include <algorithm>
#include <cmath>

#include "vision/colour/RingTable.h"
#include "vision/pixels/Sampler.h"

namespace kelpie::calibrate {
namespace {

constexpr double kRingWidth = 12.0;     // px
constexpr double kFewestInRing = 20.0;  // pixels that make a mean; noise 2 leaves 0.45 then
constexpr int kBin = 8;                 // grey levels of Cr and Cb
constexpr int kBins = 256 / kBin;
constexpr double kSurfaceRadius = 14.0;  // grey levels of chroma: carpet and its fibres, no more
constexpr int kDarkest = 25;             // chroma of darker pixels says little

using Histogram = std::array<int, static_cast<std::size_t>(kBins) * kBins>;

// The chroma bin whose three by three neighbours hold most pixels.
std::array<double, 2> densestChroma(const Histogram& histogram) {
  int max = -1;
  std::array<double, 2> best{};
  for (int cr = 1; cr + 1 < kBins; ++cr) {
    for (int cb = 1; cb + 1 < kBins; ++cb) {
      int sum = 0;
      for (int i = 0; i < 9; ++i)
        sum += histogram[static_cast<std::size_t>((cr + i / 3 - 1) * kBins + cb + i % 3 - 1)];
      if (sum <= max) continue;
      max = sum;
      best = {(cr + 0.5) * kBin, (cb + 0.5) * kBin};
    }
  }
  return best;
}

}  // namespace

Sheet wholeSheet(const std::string& name, const Image& image, int step) {
  Sheet sheet{name, {}};
  for (int py = vision::kUsableTop; py < vision::kUsableBottom; py += step)
    for (int px = vision::kUsableLeft; px < vision::kUsableRight; px += step)
      sheet.pixels.push_back({px, py, image.pixel(px, py)});
  return sheet;
}

Sheet dominantSurface(const std::string& name, const Image& image, int step) {
  const vision::RingTable published = buildRingTable(vision::ringModel2006());
  const vision::RingDistances distances;
  const Sheet all = wholeSheet(name, image, step);
  const auto corrected = [&](const SheetPixel& p) {
    return published(p.value, distances(p.px, p.py, published.centre));
  };
  Histogram histogram{};
  for (const SheetPixel& pixel : all.pixels) {
    const Yuv c = corrected(pixel);
    if (c.y >= kDarkest) ++histogram[static_cast<std::size_t>(c.cr / kBin * kBins + c.cb / kBin)];
  }
  const auto [cr, cb] = densestChroma(histogram);
  Sheet surface{name, {}};
  for (const SheetPixel& pixel : all.pixels) {
    const Yuv c = corrected(pixel);
    if (c.y >= kDarkest && std::hypot(c.cr - cr, c.cb - cb) < kSurfaceRadius)
      surface.pixels.push_back(pixel);
  }
  return surface;
}

std::uint8_t channelOf(Yuv value, std::size_t channel) {
  return channel == 0 ? value.y : channel == 1 ? value.cr : value.cb;
}

double distanceTo(const Centre& centre, const SheetPixel& pixel) {
  return std::hypot(pixel.px + 0.5 - centre[0], pixel.py + 0.5 - centre[1]);
}

void RingMeans::add(double distance, double value, double weight) {
  const auto ring = std::min(static_cast<std::size_t>(distance / kRingWidth), kRings - 1);
  sum_[ring] += weight * value;
  weight_[ring] += weight;
}

std::vector<double> RingMeans::means() const {
  std::vector<double> out;
  for (std::size_t i = 0; i < kRings; ++i)
    if (weight_[i] >= kFewestInRing) out.push_back(sum_[i] / weight_[i]);
  return out;
}

double RingMeans::rms() const {
  const auto all = means();
  double sum = 0.0;
  for (const double mean : all) sum += mean * mean;
  return all.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(all.size()));
}

double RingMeans::spread() const {
  const auto all = means();
  if (all.empty()) return 0.0;
  const auto [low, high] = std::minmax_element(all.begin(), all.end());
  return *high - *low;
}

}  // namespace kelpie::calibrate
