// SPDX-License-Identifier: Apache-2.0
// The whole object of a robot with Python inside plays the behaviours of its stick, and says in the
// system's log and by a light what goes wrong in them.
#include <gtest/gtest.h>

#include <algorithm>

#include "robot/body/Lights.h"
#include "tests/object/PlayedStick.h"
#include "tools/stick/Behaviours.h"

namespace kelpie::object {
namespace {

constexpr std::uint32_t kTheirLight = 1U << 19U;  // nobody else's
const std::uint32_t kFailed = body::lightsOf(Fallback::scriptError);

// Over a stick whose main.py has that decide().
Played playedWith(const std::string& name, const std::string& decide) {
  const stick::fs::path scripts = stick::fs::path(testing::TempDir()) / ("scripts_" + name);
  stick::put(scripts / "main.py", "import kelpie\n\n\ndef decide(world):\n    " + decide + "\n");
  stick::StickContents contents = stick::sampleContents();
  const auto zip = stick::zipBehaviours(scripts.string());
  EXPECT_TRUE(zip) << zip.error();
  contents.behaviours = *zip;
  const auto tree = stick::makeTree(*stick::sampleConfig(), contents);
  EXPECT_TRUE(tree) << tree.error();
  return played(folderOf(*tree, name));
}

int times(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

TEST(RobotScripts, ThoseOfTheStickPlay) {
  const Played result = playedWith("play", "return kelpie.Command(leds=1 << 19)");
  EXPECT_EQ(result.leds.back() & (kTheirLight | kFailed), kTheirLight);
  EXPECT_NE(result.log.find("is good; player 3, python"), std::string::npos) << result.log;
  EXPECT_EQ(times(result.log, "behaviour"), 0) << result.log;
}

TEST(RobotScripts, AnErrorIsOneLineOfTheSystemsLogAndALight) {
  const Played result = playedWith("fail", "return 1 / 0");
  EXPECT_EQ(result.leds.back() & (kTheirLight | kFailed), kFailed);
  EXPECT_EQ(times(result.log, "behaviour: "), 1) << result.log;
  EXPECT_NE(result.log.find("main.py:5: ZeroDivisionError: division by zero"), std::string::npos)
      << result.log;
}

TEST(RobotScripts, WhatDoesNotLoadIsReportedToo) {
  const Played result = playedWith("broken", "return kelpie.Command()\n\n\nimport os");
  EXPECT_EQ(result.leds.back() & kFailed, kFailed);
  EXPECT_EQ(times(result.log, "behaviour: "), 1) << result.log;
  EXPECT_NE(result.log.find("not 'os'"), std::string::npos) << result.log;
}

}  // namespace
}  // namespace kelpie::object
