// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>

#include "tools/teleop/Keys.h"

namespace kelpie::teleop {
namespace {

TEST(TeleopKeys, NoKeyMeansTwoThings) {
  std::set<char> seen;
  for (char key = ' '; key < 127; ++key)
    if (bindingOf(key) != nullptr) {
      EXPECT_EQ(bindingOf(key)->key, key);
      EXPECT_EQ(keyOf(std::string(1, key)), key);
      seen.insert(key);
    }
  EXPECT_EQ(seen.size(), 32U);
}

TEST(TeleopKeys, ArrowsAndSpaceHaveWords) {
  EXPECT_EQ(keyOf("up"), 'w');
  EXPECT_EQ(keyOf("down"), 's');
  EXPECT_EQ(keyOf("left"), 'a');
  EXPECT_EQ(keyOf("right"), 'd');
  EXPECT_EQ(keyOf("space"), ' ');
  EXPECT_EQ(keyOf(""), 0);
  EXPECT_EQ(keyOf("ww"), 0);
}

TEST(TeleopKeys, EveryMotionButGettingUpAndHoldHasAKey) {
  std::set<MotionKind> motions;
  for (char key = ' '; key < 127; ++key)
    if (bindingOf(key) != nullptr) motions.insert(bindingOf(key)->motion);
  EXPECT_EQ(motions.size(), kMotionKindCount - 5U);
}

TEST(TeleopKeys, ArrowsOfATerminalAreTakenApart) {
  std::string typed = "1\033[A\033OC?x";
  EXPECT_EQ(takeKey(typed), '1');
  EXPECT_EQ(takeKey(typed), 'w');
  EXPECT_EQ(takeKey(typed), 'd');
  EXPECT_EQ(takeKey(typed), 'x');  // a key that means nothing is passed over
  EXPECT_EQ(takeKey(typed), 0);
}

TEST(TeleopKeys, HalfAnArrowWaitsForTheOtherHalf) {
  std::string typed = "\033[";
  EXPECT_EQ(takeKey(typed), 0);
  typed += "B";
  EXPECT_EQ(takeKey(typed), 's');
}

TEST(TeleopKeys, AFileHasTimesKeysAndComments) {
  const auto keys = readKeys("# ahead\n1 w\n\n1.5 space  # stop\n", "f");
  ASSERT_TRUE(keys) << keys.error();
  ASSERT_EQ(keys->size(), 2U);
  EXPECT_EQ((*keys)[1].seconds, 1.5);
  EXPECT_EQ((*keys)[1].key, ' ');
}

TEST(TeleopKeys, WhatIsWrongInAFileIsNamedWithItsLine) {
  const auto error = [](const char* text) { return readKeys(text, "f").error(); };
  EXPECT_EQ(error("1 w\nnow w\n"), "f:2: 'now' is not a time of 0 to 3600 s");
  EXPECT_EQ(error("nan w\n"), "f:1: 'nan' is not a time of 0 to 3600 s");
  EXPECT_EQ(error("1\n"), "f:1: wants TIME KEY, but has no key");
  EXPECT_EQ(error("1 w w\n"), "f:1: wants TIME KEY, but has more words");
  EXPECT_EQ(error("1 W\n"), "f:1: 'W' is not a key; kelpie teleop --help lists them");
  EXPECT_EQ(error("2 w\n1 w\n"), "f:2: '1' is before the line above");
  EXPECT_EQ(error("# nothing\n"), "f: holds no keys");
}

}  // namespace
}  // namespace kelpie::teleop
