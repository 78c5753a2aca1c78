// SPDX-License-Identifier: Apache-2.0
#include "vision/colour/ColourBuilder.h"

#include <array>
#include <cmath>
#include <utility>

#include "robot/core/Maths.h"

namespace kelpie::vision {
namespace {

// A step of 12 in brightness beyond the shading range counts as much as the whole chroma radius.
constexpr double kBrightnessRadius = 12.0;
// How far the chroma follows the shading: 0 = not, 1 = in proportion.
constexpr double kChromaFollows = 0.6;
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

// Where no colour in glare is, told by whole numbers: looking at every cell as closely as
// nearestOf() does doubled a robot's time to its first command (toolchain/budget, first_command).
bool isFarFromGlare(Yuv c) {
  constexpr int kDarkest = 104;
  constexpr int kWidest = 60;  // of the chroma, from grey
  const int cr = c.cr - static_cast<int>(kNeutralChroma);
  const int cb = c.cb - static_cast<int>(kNeutralChroma);
  return c.y < kDarkest || cr * cr + cb * cb > kWidest * kWidest;
}

// Squared distance in units of the prototype's radius: 1 is the rim.
double squaredDistance(const Prototype& p, Yuv c) {
  const double shade = maths::clamp(c.y / p.y, p.darkest, p.brightest);
  const double saturation =
      1.0 - kChromaFollows + kChromaFollows * maths::clamp(shade, 0.0, kMaxChromaShade);
  const double dCr = c.cr - (kNeutralChroma + saturation * (p.cr - kNeutralChroma));
  const double dCb = c.cb - (kNeutralChroma + saturation * (p.cb - kNeutralChroma));
  const double dY = c.y - shade * p.y;
  return (dCr * dCr + dCb * dCb) / maths::square(p.radius) + maths::square(dY / kBrightnessRadius);
}

// Of the nearest of these prototypes, with its class: none beyond 1.
template <class Prototypes>
std::pair<double, ColourClass> nearestOf(const Prototypes& prototypes, Yuv c) {
  std::pair<double, ColourClass> best{1.0, ColourClass::none};
  for (const Prototype& p : prototypes) {
    const double d = squaredDistance(p, c);
    if (d < best.first) best = {d, p.colour};
  }
  return best;
}

}  // namespace

std::vector<Prototype> nominalPrototypes() {
  return std::vector<Prototype>(kNominalPrototypes.begin(), kNominalPrototypes.end());
}

ColourTable buildColourTable(const std::vector<Prototype>& prototypes) {
  ColourTable table;
  for (std::size_t cell = 0; cell < ColourTable::kCells; ++cell)
    table.set(cell, nearestOf(prototypes, ColourTable::centreOf(cell)).second);
  return table;
}

ColourTable withGlare(const ColourTable& even) {
  ColourTable table = even;
  for (std::size_t cell = 0; cell < ColourTable::kCells; ++cell) {
    const ColourClass colour = even.at(cell);
    if (colour != ColourClass::none && colour != ColourClass::white) continue;
    const Yuv centre = ColourTable::centreOf(cell);
    if (isFarFromGlare(centre)) continue;
    const auto glare = nearestOf(kGlarePrototypes, centre);
    if (glare.second == ColourClass::none) continue;
    if (glare.first < nearestOf(kNominalPrototypes, centre).first) table.set(cell, glare.second);
  }
  return table;
}

}  // namespace kelpie::vision
