// SPDX-License-Identifier: Apache-2.0
#include "tools/calibrate/KernelTrainer.h"

#include <algorithm>
#include <cmath>

namespace kelpie::calibrate {
namespace {

using vision::ColourClass;
using vision::kColourClassCount;

constexpr double kNarrowest = 0.5;  // of an adapted width, in plain widths
constexpr double kWidest = 2.5;
constexpr std::size_t kFolds = 4;
// Share of pixels by which another kernel must beat the default; less is the folds' noise.
constexpr double kClearly = 0.01;

struct Axis {
  int bits = 0;
  int cells() const { return 1 << bits; }
  int cellOf(int value) const { return value >> (8 - bits); }
  double centreOf(int cell) const {
    const double size = 1 << (8 - bits);
    return (cell + 0.5) * size - 0.5;
  }
};

// One axis of a bump: weights of the cells first, first + 1, ...
struct Profile {
  int first = 0;
  std::vector<double> weight;
};

Profile profileOf(const Axis& axis, double value, double width, double reach) {
  Profile profile;
  const double size = 1 << (8 - axis.bits);
  const int low = static_cast<int>(std::floor((value - reach * width) / size));
  const int high = static_cast<int>(std::floor((value + reach * width) / size));
  profile.first = std::max(0, low);
  for (int cell = profile.first; cell <= std::min(high, axis.cells() - 1); ++cell) {
    const double away = (axis.centreOf(cell) - value) / width;
    profile.weight.push_back(std::exp(-0.5 * away * away));
  }
  return profile;
}

struct Axes {
  Axis y;
  Axis cr;
  Axis cb;
  explicit Axes(const TableBits& bits) : y{bits.y}, cr{bits.cr}, cb{bits.cb} {}
  std::size_t cells() const {
    return static_cast<std::size_t>(y.cells()) * static_cast<std::size_t>(cr.cells()) *
           static_cast<std::size_t>(cb.cells());
  }
  std::size_t at(int cellY, int cellCr, int cellCb) const {
    return (static_cast<std::size_t>(cellY) << (cr.bits + cb.bits)) |
           (static_cast<std::size_t>(cellCr) << cb.bits) | static_cast<std::size_t>(cellCb);
  }
  std::size_t at(Yuv p) const { return at(y.cellOf(p.y), cr.cellOf(p.cr), cb.cellOf(p.cb)); }
};

// Calls add(cell, weight) for the cells within reach of a pixel; `wide` multiplies its widths.
template <class Add>
void forBump(const Axes& axes, const KernelParams& params, Yuv p, double wide, Add&& add) {
  const Profile y = profileOf(axes.y, p.y, wide * params.widthY, params.reach);
  const Profile cr = profileOf(axes.cr, p.cr, wide * params.widthChroma, params.reach);
  const Profile cb = profileOf(axes.cb, p.cb, wide * params.widthChroma, params.reach);
  const double height = 1.0 / (wide * wide * wide);
  const double rim = height * std::exp(-0.5 * params.reach * params.reach);
  for (std::size_t i = 0; i < y.weight.size(); ++i)
    for (std::size_t j = 0; j < cr.weight.size(); ++j) {
      const std::size_t first =
          axes.at(y.first + static_cast<int>(i), cr.first + static_cast<int>(j), cb.first);
      const double outer = height * y.weight[i] * cr.weight[j];
      for (std::size_t k = 0; k < cb.weight.size(); ++k)
        if (outer * cb.weight[k] >= rim) add(first + k, outer * cb.weight[k]);
    }
}

// The density of all pixels together, at each one's own colour. Its cells are two levels wide: in
// the table's own cells the widths would follow the table's steps.
std::vector<double> densityAtPixels(const LabelledPixels& pixels, const KernelParams& params) {
  const Axes fine({7, 7, 7});
  std::vector<double> density(fine.cells(), 0.0);
  for (const auto& p : pixels)
    forBump(fine, params, p.value, 1.0,
            [&](std::size_t cell, double weight) { density[cell] += weight; });
  std::vector<double> out;
  for (const auto& p : pixels) out.push_back(density[fine.at(p.value)]);
  return out;
}

// Abramson: width in proportion to density^-adapts, 1 in the geometric mean.
std::vector<double> adaptedWidths(const LabelledPixels& pixels, const KernelParams& params) {
  auto widths = densityAtPixels(pixels, params);
  double logs = 0.0;
  for (const double density : widths) logs += std::log(density);
  const double mean = std::exp(logs / static_cast<double>(widths.size()));
  for (double& width : widths)
    width = maths::clamp(std::pow(width / mean, -params.adapts), kNarrowest, kWidest);
  return widths;
}

using Densities = std::array<std::vector<double>, kColourClassCount>;

Densities densitiesOf(const LabelledPixels& pixels, const Axes& axes, const KernelParams& params) {
  Densities densities;
  const auto widths = adaptedWidths(pixels, params);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    auto& own = densities[vision::index(pixels[i].colour)];
    own.resize(axes.cells(), 0.0);
    forBump(axes, params, pixels[i].value, widths[i],
            [&](std::size_t cell, double weight) { own[cell] += weight; });
  }
  return densities;
}

std::array<double, kColourClassCount> classFactors(const LabelledPixels& pixels, double balance) {
  std::array<double, kColourClassCount> factors{};
  for (const auto& p : pixels) factors[vision::index(p.colour)] += 1.0;
  for (double& f : factors) f = f > 0.0 ? std::pow(f, balance) : 0.0;
  return factors;
}

GridTable highest(const Densities& densities, const TableBits& bits,
                  const std::array<double, kColourClassCount>& factors) {
  GridTable table{bits, std::vector<ColourClass>(Axes(bits).cells(), ColourClass::none)};
  std::vector<double> most(table.cells.size(), 0.0);
  for (std::size_t c = 0; c < kColourClassCount; ++c)
    for (std::size_t cell = 0; cell < densities[c].size(); ++cell) {
      const double score = factors[c] * densities[c][cell];
      if (score <= most[cell]) continue;
      most[cell] = score;
      table.cells[cell] = static_cast<ColourClass>(c);
    }
  return table;
}

// Every kFolds-th pixel; the caller has mixed them.
Split foldOf(const LabelledPixels& pixels, std::size_t fold) {
  Split split;
  for (std::size_t i = 0; i < pixels.size(); ++i)
    (i % kFolds == fold ? split.heldOut : split.training).push_back(pixels[i]);
  return split;
}

// Pixels that are right over all folds.
double rightWith(const std::vector<Split>& folds, const KernelParams& params,
                 const TableBits& bits) {
  double right = 0.0;
  for (const Split& fold : folds) {
    const auto table = trainTable(fold.training, params, bits);
    for (const auto& p : fold.heldOut) right += table(p.value) == p.colour ? 1.0 : 0.0;
  }
  return right;
}

}  // namespace

std::size_t GridTable::cellOf(Yuv p) const { return Axes(bits).at(p); }

GridTable trainTable(const LabelledPixels& pixels, const KernelParams& params,
                     const TableBits& bits) {
  return highest(densitiesOf(pixels, Axes(bits), params), bits,
                 classFactors(pixels, params.balance));
}

KernelParams chooseKernel(const LabelledPixels& pixels, const TableBits& bits, Random& random) {
  const auto mixed = splitLabelled(pixels, 0.0, random).training;
  std::vector<Split> folds;
  for (std::size_t fold = 0; fold < kFolds; ++fold) folds.push_back(foldOf(mixed, fold));
  KernelParams best;
  double most = rightWith(folds, best, bits) + kClearly * static_cast<double>(pixels.size());
  for (const double chroma : {2.5, 4.0, 6.0})
    for (const double ratio : {1.0, 1.5}) {
      KernelParams tried;
      tried.widthChroma = chroma;
      tried.widthY = ratio * chroma;
      const double right = rightWith(folds, tried, bits);
      if (right <= most) continue;
      most = right;
      best = tried;
    }
  return best;
}

vision::ColourTable robotTable(const GridTable& grid) {
  vision::ColourTable table;
  for (std::size_t cell = 0; cell < vision::ColourTable::kCells; ++cell)
    table.set(cell, grid(vision::ColourTable::centreOf(cell)));
  return table;
}

double accuracyOf(const Confusion& confusion) {
  int right = 0;
  int all = 0;
  for (std::size_t i = 0; i < kColourClassCount; ++i)
    for (std::size_t j = 0; j < kColourClassCount; ++j) {
      all += confusion[i][j];
      if (i == j) right += confusion[i][j];
    }
  return all > 0 ? static_cast<double>(right) / all : 0.0;
}

ColourClass nearestNeighbours(const LabelledPixels& pixels, Yuv value, std::size_t count) {
  std::vector<std::pair<int, std::size_t>> near;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Yuv p = pixels[i].value;
    near.emplace_back(maths::square(p.y - value.y) + maths::square(p.cr - value.cr) +
                          maths::square(p.cb - value.cb),
                      i);
  }
  const auto end = near.begin() + static_cast<std::ptrdiff_t>(std::min(count, near.size()));
  std::partial_sort(near.begin(), end, near.end());
  std::array<int, kColourClassCount> votes{};
  for (auto it = near.begin(); it != end; ++it) ++votes[vision::index(pixels[it->second].colour)];
  return static_cast<ColourClass>(std::max_element(votes.begin(), votes.end()) - votes.begin());
}

}  // namespace kelpie::calibrate
