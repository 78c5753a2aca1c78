// SPDX-License-Identifier: Apache-2.0
#include "vision/colour/ColourBuilder.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "robot/core/Maths.h"

namespace kelpie::vision {
namespace {

// A step of 12 in brightness beyond the shading range counts as much as the whole chroma radius.
constexpr double kBrightnessRadius = 12.0;
// How far the chroma follows the shading: 0 = not, 1 = in proportion.
constexpr double kChromaFollows = 0.6;
constexpr std::size_t kCellsOfABrightness = std::size_t{1}
                                            << (ColourTable::kBitsCr + ColourTable::kBitsCb);
constexpr double kMaxChromaShade = 1.1;  // of y; brighter glare adds no more chroma

// Class; Y, Cr, Cb; darkest and brightest share of Y; radius. Blue ends at a little over half of
// its light: with less, it took the dark blue robots' noisier pixels (3 % of them; 0 to 0.4 % now,
// kelpie evaluate colour).
constexpr std::array<Prototype, kColourClassCount - 1> kNominalPrototypes = {
    {{ColourClass::orange, 140, 181, 79, 0.35, 1.5, 27},
     {ColourClass::blue, 82, 121, 167, 0.55, 1.9, 26},
     {ColourClass::yellow, 120, 160, 61, 0.45, 1.7, 27},
     {ColourClass::pink, 113, 193, 124, 0.45, 1.7, 27},
     {ColourClass::robotBlue, 28, 126, 147, 0.5, 1.3, 14},
     {ColourClass::robotRed, 85, 165, 131, 0.4, 1.4, 20},
     {ColourClass::green, 77, 103, 97, 0.4, 1.8, 25},
     {ColourClass::grey, 95, 127, 128, 0.7, 1.3, 14},
     {ColourClass::white, 189, 124, 129, 0.7, 1.4, 20},
     {ColourClass::black, 20, 126, 128, 0.0, 1.6, 12}}};

// Landmarks that a light shines on: twice as bright, half as colourful. Narrower than the even
// ones, since the white of walls and lines is near.
constexpr std::array<Prototype, 3> kGlarePrototypes = {
    {{ColourClass::blue, 164, 124.5, 147.5, 0.75, 1.5, 14},
     {ColourClass::yellow, 235, 144, 94.5, 0.75, 1.1, 18},
     {ColourClass::pink, 226, 160.5, 126, 0.75, 1.15, 18}}};

// A prototype as it looks at one brightness.
struct Shaded {
  ColourClass colour = ColourClass::none;
  double cr = kNeutralChroma;
  double cb = kNeutralChroma;
  double squaredRadius = 1.0;
  double squaredDistance = 0.0;  // in brightness, in units of kBrightnessRadius
};

Shaded shadedAt(const Prototype& p, double y) {
  const double shade = maths::clamp(y / p.y, p.darkest, p.brightest);
  const double saturation =
      1.0 - kChromaFollows + kChromaFollows * maths::clamp(shade, 0.0, kMaxChromaShade);
  return {p.colour, kNeutralChroma + saturation * (p.cr - kNeutralChroma),
          kNeutralChroma + saturation * (p.cb - kNeutralChroma), maths::square(p.radius),
          maths::square((y - shade * p.y) / kBrightnessRadius)};
}

// Those of the prototypes that may take a cell of that brightness.
template <class Prototypes>
std::vector<Shaded> reaching(const Prototypes& prototypes, double y) {
  std::vector<Shaded> near;
  for (const Prototype& p : prototypes) {
    const Shaded shaded = shadedAt(p, y);
    if (shaded.squaredDistance < 1.0) near.push_back(shaded);
  }
  return near;
}

// Of the nearest of these, with its class: none beyond 1, a prototype's rim.
std::pair<double, ColourClass> nearestOf(const std::vector<Shaded>& prototypes, Yuv c) {
  std::pair<double, ColourClass> best{1.0, ColourClass::none};
  for (const Shaded& p : prototypes) {
    const double squared = maths::square(c.cr - p.cr) + maths::square(c.cb - p.cb);
    if (squared >= p.squaredRadius) continue;  // spares a robot most of the divisions
    const double d = squared / p.squaredRadius + p.squaredDistance;
    if (d < best.first) best = {d, p.colour};
  }
  return best;
}

// Calls back with each brightness' first cell, and that brightness.
template <class Each>
void forEachBrightness(Each each) {
  for (std::size_t cell = 0; cell < ColourTable::kCells; cell += kCellsOfABrightness)
    each(cell, ColourTable::centreOf(cell).y);
}

// Calls back with the cells of a brightness that lie in the square round the prototype's rim.
template <class Each>
void forEachCellAround(const Shaded& p, std::size_t first, Each each) {
  constexpr int kStep = 1 << (ColourTable::kByteBits - ColourTable::kBitsCr);
  static_assert(ColourTable::kBitsCr == ColourTable::kBitsCb);
  constexpr int kCount = 1 << ColourTable::kBitsCr;
  const double radius = std::sqrt(p.squaredRadius);
  const auto cellAt = [](double chroma) {
    return maths::clamp(static_cast<int>(chroma) / kStep, 0, kCount - 1);
  };
  for (int cr = cellAt(p.cr - radius); cr <= cellAt(p.cr + radius); ++cr)
    for (int cb = cellAt(p.cb - radius); cb <= cellAt(p.cb + radius); ++cb)
      each(first + static_cast<std::size_t>(cr * kCount + cb));
}

}  // namespace

std::vector<Prototype> nominalPrototypes() {
  return std::vector<Prototype>(kNominalPrototypes.begin(), kNominalPrototypes.end());
}

ColourTable buildColourTable(const std::vector<Prototype>& prototypes) {
  ColourTable table;
  forEachBrightness([&](std::size_t first, double y) {
    const std::vector<Shaded> near = reaching(prototypes, y);
    for (std::size_t cell = first; cell < first + kCellsOfABrightness; ++cell)
      table.set(cell, nearestOf(near, ColourTable::centreOf(cell)).second);
  });
  return table;
}

ColourTable withGlare(const ColourTable& even) {
  ColourTable table = even;
  forEachBrightness([&](std::size_t first, double y) {
    const std::vector<Shaded> glare = reaching(kGlarePrototypes, y);
    const std::vector<Shaded> nominal = reaching(kNominalPrototypes, y);
    const auto brighten = [&](std::size_t cell) {
      const ColourClass colour = even.at(cell);
      if (colour != ColourClass::none && colour != ColourClass::white) return;
      const Yuv centre = ColourTable::centreOf(cell);
      const auto found = nearestOf(glare, centre);
      if (found.second != ColourClass::none && found.first < nearestOf(nominal, centre).first)
        table.set(cell, found.second);
    };
    for (const Shaded& p : glare) forEachCellAround(p, first, brighten);
  });
  return table;
}

}  // namespace kelpie::vision
