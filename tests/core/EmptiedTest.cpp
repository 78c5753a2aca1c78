// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>

#include "robot/core/fields/Emptied.h"
#include "robot/core/fields/FieldCheck.h"
#include "robot/core/types/Percepts.h"
#include "robot/core/types/WorldModel.h"
#include "tests/core/RandomValue.h"

namespace kelpie {
namespace {

template <class S>
void expectEmptied() {
  Random random(3);
  const auto used = std::make_unique<S>();
  const auto fresh = std::make_unique<S>();
  randomise(*used, random);
  std::string path;
  ASSERT_TRUE(firstDifference(*used, *fresh, &path));
  makeEmpty(*used);
  EXPECT_FALSE(firstDifference(*used, *fresh, &path)) << path;
}

TEST(Emptied, StructsOfAFrameAreAsNew) {
  expectEmptied<Percepts>();
  expectEmptied<WorldModel>();
}

TEST(Emptied, ListsHoldNothingBeyondWhatIsCopied) {
  FixedVector<int, 8> to;
  for (int i = 0; i < 8; ++i) to.push_back(7);
  FixedVector<int, 8> from;
  from.push_back(1);
  copyUsed(to, from);
  ASSERT_EQ(to.size(), 1U);
  EXPECT_EQ(to[0], 1);
  to.resize(8);
  for (std::size_t i = 1; i < 8; ++i) EXPECT_EQ(to[i], 0);
}

TEST(Emptied, AListOfAStepIsCopiedAsFarAsItIsUsed) {
  ScratchVector<int, 8> from;
  for (int i = 0; i < 8; ++i) EXPECT_TRUE(from.push_back(i));
  EXPECT_FALSE(from.push_back(8)) << "full";
  from.resize(2);
  FixedVector<int, 8> to;
  copyUsed(to, from);
  ASSERT_EQ(to.size(), 2U);
  EXPECT_EQ(to[0] + 10 * to[1], 10);
  from.resize(4);
  EXPECT_EQ(from[2] + from[3], 0) << "grown with default values";
  from.clear();
  EXPECT_TRUE(from.empty());
}

}  // namespace
}  // namespace kelpie
