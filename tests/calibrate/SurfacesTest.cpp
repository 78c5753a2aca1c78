// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>

#include "tests/calibrate/SheetMaker.h"
#include "tools/calibrate/colour/Surfaces.h"

namespace kelpie::calibrate {
namespace {

using vision::ColourClass;
using vision::SurfaceColour;

// A light with three fifths of the nominal one's brightness.
constexpr std::array<SurfaceColour, 5> kLit = {
    {{46, 113, 109}, {113, 126, 129}, {49, 124, 151}, {72, 147, 88}, {68, 167, 126}}};

std::string inFolder(const std::string& name) { return KELPIE_OUT "/surfaces_" + name; }

// One image of each surface, a box of each, and where they are listed.
std::string labelledImages() {
  Random random(5);
  std::ofstream boxes(inFolder("boxes.txt"));
  for (std::size_t i = 0; i < kLit.size(); ++i) {
    const Paper paper{kLit[i].y, kLit[i].cr, kLit[i].cb};
    const std::string name = "surfaces_" + std::to_string(i) + ".yuv";
    const Image image = sheetImage(paper, vision::ringModel2006(), random);
    std::ofstream file(KELPIE_OUT "/" + name, std::ios::binary);
    for (const Image::Plane* plane : {&image.y, &image.cr, &image.cb})
      file.write(reinterpret_cast<const char*>(plane->data()),
                 static_cast<std::streamsize>(plane->size()));
    boxes << name << " 20 20 60 60 " << vision::kColourNames[index(kLitSurfaces[i].colour)] << '\n';
  }
  return inFolder("boxes.txt");
}

LabelledPixels even(std::size_t count) {
  LabelledPixels pixels;
  for (std::size_t i = 0; i < kLit.size(); ++i) {
    const auto byte = [](double value) { return static_cast<std::uint8_t>(value); };
    const Yuv value{byte(kLit[i].y), byte(kLit[i].cr), byte(kLit[i].cb)};
    pixels.insert(pixels.end(), count, {value, kLitSurfaces[i].colour});
  }
  return pixels;
}

void expectNear(const SurfaceColour& found, const SurfaceColour& painted, const char* name) {
  EXPECT_NEAR(found.y, painted.y, 2.0) << name;
  EXPECT_NEAR(found.cr, painted.cr, 2.0) << name;
  EXPECT_NEAR(found.cb, painted.cb, 2.0) << name;
}

TEST(Surfaces, LabelledImagesGiveTheColoursThatTheMiddleOfTheImageWouldShow) {
  const auto pixels = readRegions(labelledImages(), buildRingTable(vision::ringModel2006()));
  ASSERT_TRUE(pixels) << pixels.error();
  const auto found = surfacesOf(*pixels);
  ASSERT_TRUE(found) << found.error();
  for (std::size_t i = 0; i < kLit.size(); ++i)
    expectNear((*found).*kLitSurfaces[i].member, kLit[i], kLitSurfaces[i].name);
  EXPECT_TRUE(found->follow);
}

TEST(Surfaces, AFifthOfLabelsBesideTheSurfaceMovesItsColourByNothing) {
  LabelledPixels pixels = even(100);
  pixels.insert(pixels.end(), 25, {{230, 128, 128}, ColourClass::green});
  const auto found = surfacesOf(pixels);
  ASSERT_TRUE(found) << found.error();
  EXPECT_EQ(found->carpet.y, kLit[0].y);
  EXPECT_EQ(found->carpet.cb, kLit[0].cb);
}

TEST(Surfaces, AClassWithFewLabelsIsNamed) {
  LabelledPixels pixels = even(30);
  pixels.resize(4 * 30 + 19);  // pink is the last
  EXPECT_EQ(surfacesOf(pixels).error(), "19 pixels are labelled pink, 20 tell its colour");
}

TEST(Surfaces, ALandmarkWithoutColourTellsNoLightButALineMay) {
  LabelledPixels pixels = even(30);
  for (LabelledPixel& p : pixels)
    if (p.colour == ColourClass::white) p.value = {180, 128, 128};
  EXPECT_TRUE(surfacesOf(pixels));
  for (LabelledPixel& p : pixels)
    if (p.colour == ColourClass::blue) p.value = {180, 129, 127};
  EXPECT_EQ(surfacesOf(pixels).error(), "what is labelled blue is grey: it tells no light");
}

TEST(Surfaces, BlackCarpetIsRefusedAsNoParameterWouldTakeIt) {
  LabelledPixels pixels = even(30);
  for (LabelledPixel& p : pixels)
    if (p.colour == ColourClass::green) p.value.y = 4;
  EXPECT_EQ(surfacesOf(pixels).error().find("what is labelled green is too dark: "), 0U);
}

}  // namespace
}  // namespace kelpie::calibrate
