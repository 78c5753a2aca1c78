// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>

#include "tools/teleop/Blocks.h"

namespace kelpie::teleop {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

std::unique_ptr<Image> greyAboveWhite() {
  auto image = std::make_unique<Image>();
  image->cr.fill(128);
  image->cb.fill(128);
  const std::size_t half = image->y.size() / 2;
  for (std::size_t i = 0; i < image->y.size(); ++i) image->y[i] = i < half ? 100 : 255;
  return image;
}

TEST(TeleopBlocks, PictureFitsAndKeepsItsShape) {
  for (const TextSize room : {TextSize{80, 20}, {200, 50}, {30, 60}, {400, 200}}) {
    const TextSize size = pictureSize(room);
    EXPECT_TRUE(size.columns <= room.columns && size.rows <= room.rows) << room.columns;
    EXPECT_NEAR(size.columns, 2.6 * size.rows, 2.6) << room.columns;
  }
}

TEST(TeleopBlocks, NoPictureWhereNothingCouldBeSeen) {
  EXPECT_EQ(pictureSize({20, 50}).rows, 0);
  EXPECT_EQ(pictureSize({80, 5}).rows, 0);
  EXPECT_EQ(pictureSize({0, -3}).rows, 0);
}

TEST(TeleopBlocks, EachRowHasItsColoursAndEndsPlain) {
  const auto lines = blocksOf(*greyAboveWhite(), {26, 10});
  ASSERT_EQ(lines.size(), 10U);
  for (const auto& line : lines) {
    EXPECT_EQ(count(line, "\u2580"), 26U);
    EXPECT_EQ(line.substr(line.size() - 4), "\033[0m");
  }
  EXPECT_NE(lines.front().find("\033[38;2;100;100;100m"), std::string::npos);
  EXPECT_NE(lines.back().find("\033[48;2;255;255;255m"), std::string::npos);
}

TEST(TeleopBlocks, ColourThatStaysIsSentOnce) {
  EXPECT_EQ(count(blocksOf(*greyAboveWhite(), {26, 10}).front(), "\033["), 3U);
}

}  // namespace
}  // namespace kelpie::teleop
