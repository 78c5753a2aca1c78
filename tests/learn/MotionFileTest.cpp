// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "robot/core/fields/FieldCheck.h"
#include "tools/learn/motion/MotionFile.h"
#include "tools/learn/motion/MotionSpace.h"

namespace kelpie::learn {
namespace {

using actuator::MotionData;

std::filesystem::path motionsFolder() {
  return std::filesystem::path(KELPIE_SOURCE_DIR) / "actuator/data/motions";
}

Expected<MotionData> readText(const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() / "kelpie_motion_test.toml";
  std::ofstream(path) << text;
  auto motion = readMotion(path.string());
  std::filesystem::remove(path);
  return motion;
}

const std::string kFrame = "[[frame]]\nticks = 5\nfront = [1, 2, 3]\nhind = [4, 5, 6]\n";

std::string complaint(const std::string& text) {
  const auto motion = readText(text);
  return motion.ok() ? "" : motion.error();
}

TEST(MotionFile, EveryStandardMotionReadsAsItWasCompiledIn) {
  for (std::size_t i = 1; i < kMotionKindCount; ++i) {
    const auto path = motionsFolder() / (std::string(actuator::kMotionNames[i]) + ".toml");
    const MotionData& compiled = actuator::standardMotions().of[i];
    ASSERT_EQ(std::filesystem::exists(path), !compiled.frames.empty()) << path;
    if (compiled.frames.empty()) continue;
    const auto read = readMotion(path.string());
    ASSERT_TRUE(read.ok()) << read.error();
    std::string where;
    EXPECT_FALSE(firstDifference(*read, compiled, &where)) << path << ": " << where;
  }
}

TEST(MotionFile, WhatIsWrittenReadsTheSame) {
  for (const MotionData& motion : actuator::standardMotions().of) {
    if (motion.frames.empty()) continue;
    const auto read = readText(motionText(motion, "written"));
    ASSERT_TRUE(read.ok()) << read.error();
    EXPECT_EQ(motionText(*read, "written"), motionText(motion, "written"));
    EXPECT_EQ(read->frames.size(), motion.frames.size());
  }
}

// Each of these is rounded to the default, or to its other side's number, in the text.
TEST(MotionFile, WhatIsRoundedAwayIsWrittenAlikeWhenItIsReadAgain) {
  for (const char* text : {"slew = 20.04\n", "kick = { distance = 0.3, ahead = 5 }\n",
                           "way = { forward = 0.04 }\n", "way = { left = -0.04, turn = 0.01 }\n"}) {
    const std::string written = motionText(*readText(text + kFrame), "");
    EXPECT_EQ(motionText(*readText(written), ""), written);
  }
  for (const char* frame : {"legs = \"walk\"\nforward = -0.04\nturn = 0.04\n",
                            "left_front = [1, 2, 3]\nleft_hind = [4, 5, 6]\n"
                            "right_front = [1, 2, 3.01]\nright_hind = [4, 5, 6]\n"}) {
    const std::string written =
        motionText(*readText(std::string("[[frame]]\nticks = 5\n") + frame), "");
    EXPECT_EQ(motionText(*readText(written), ""), written);
  }
}

TEST(MotionFile, WordsAboutItMayHoldQuotesAndBackslashes) {
  const MotionData motion = *readText(kFrame);
  for (const char* about :
       {"\"\"\"", "C:\\motion\\new", "ends with \"", "a\tb\x01\r\x7f\n\u00e9"}) {
    const auto read = readText(motionText(motion, about));
    EXPECT_TRUE(read.ok()) << read.error();
  }
}

TEST(MotionFile, AMirrorImageTwiceIsTheMotionItself) {
  for (const MotionData& motion : actuator::standardMotions().of) {
    std::string where;
    EXPECT_FALSE(firstDifference(mirrored(mirrored(motion)), motion, &where)) << where;
  }
}

TEST(MotionFile, WhatIsWrongIsReportedByLineOrName) {
  EXPECT_NE(complaint("slew = 5\n").find("has no [[frame]]"), std::string::npos);
  EXPECT_NE(complaint(kFrame + "speed = 3\n").find("speed: there is no such key"),
            std::string::npos);
  EXPECT_NE(complaint("[[frame]]\nticks = 5\nfront = [1, 2]\nhind = [4, 5, 6]\n")
                .find(":3: front: wants 3 angles"),
            std::string::npos);
  EXPECT_NE(complaint("[[frame]]\nticks = 5\nleft_front = [1, 2, 3]\n").find("a leg has no angles"),
            std::string::npos);
  EXPECT_NE(complaint("[[frame]]\nticks = 9000\nlegs = \"stay\"\n").find("ticks"),
            std::string::npos);
  EXPECT_NE(complaint("[[frame]]\nticks = -1\nlegs = \"stay\"\n").find("ticks"), std::string::npos);
  EXPECT_NE(complaint("[[frame]]\nticks = 5\nlegs = \"fly\"\n").find("legs: there is no such one"),
            std::string::npos);
  EXPECT_NE(complaint("[[frame]]\nticks = 5\nfront = [1, 2, 300]\nhind = [4, 5, 6]\n")
                .find("wants 3 angles"),
            std::string::npos);
  EXPECT_NE(complaint("[[frame]]\nticks = 2.5\nlegs = \"stay\"\n").find("no whole number"),
            std::string::npos);
  EXPECT_NE(complaint("way = 3\n" + kFrame).find(":1: way: is no table"), std::string::npos);
  EXPECT_NE(complaint("kick = \"far\"\n" + kFrame).find("kick: is no table"), std::string::npos);
  EXPECT_NE(complaint("about = 3\n" + kFrame).find("about: is a text"), std::string::npos);
  EXPECT_NE(complaint("hurried_by = \"wind\"\n" + kFrame).find("hurried_by: there is no such one"),
            std::string::npos);
  EXPECT_NE(complaint("mirror = \"nothing\"\n").find("is no motion"), std::string::npos);
  EXPECT_NE(complaint("mirror = \"nothing\"\nslew = 5\n").find(":2: slew: is not beside mirror"),
            std::string::npos);
  EXPECT_NE(complaint("slew = [\n").find("toml:"), std::string::npos);
  EXPECT_NE(readMotion("/nowhere/at/all.toml").error().find("No such file"), std::string::npos);
  EXPECT_NE(readMotion("/tmp").error().find("is a directory"), std::string::npos);
}

TEST(MotionFile, GainOfAFrameIsAShareOfTheStandardOne) {
  const auto motion = readText(kFrame + "gain = 0.45\n" + kFrame);
  ASSERT_TRUE(motion.ok()) << motion.error();
  EXPECT_EQ(motion->frames[0].gain, 0.45);
  EXPECT_EQ(motion->frames[1].gain, 1.0);
  const auto again = readText(motionText(*motion, "written"));
  ASSERT_TRUE(again.ok()) << again.error();
  EXPECT_EQ(again->frames[0].gain, 0.45);
}

TEST(MotionFile, GainThatIsNoShareIsReportedInOneLine) {
  for (const char* value : {"0.1", "1.5", "-1", "nan", "inf"}) {
    const std::string text = complaint(kFrame + "gain = " + value + "\n");
    EXPECT_NE(text.find("frames[0].gain: "), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
  for (const char* value : {"\"soft\"", "true", "[0.4, 1]"})
    EXPECT_NE(complaint(kFrame + "gain = " + value + "\n").find(":5: gain: is a number"),
              std::string::npos);
}

TEST(MotionFile, ThirteenFramesAreTooMany) {
  std::string text;
  for (int i = 0; i < 13; ++i) text += kFrame;
  EXPECT_NE(complaint(text).find("more than 12"), std::string::npos);
}

TEST(MotionSpace, ThePointWhereItStartsIsTheMotionItself) {
  const MotionData& kick = actuator::standardMotions()[MotionKind::kickForward];
  const SearchSpace space = motionSpace(kick, Angle::deg(30.0));
  EXPECT_EQ(motionText(motionOf(space.start, kick), ""), motionText(kick, ""));
}

TEST(MotionSpace, LegsThatAreAlikeStayAlike) {
  MotionData kick = actuator::standardMotions()[MotionKind::kickForward];
  SearchSpace space = motionSpace(kick, Angle::deg(30.0));
  for (double& number : space.start) number += 2.0;
  const MotionData other = motionOf(space.start, kick);
  for (const auto& key : other.frames)
    for (std::size_t j = 0; j < actuator::kLegJoints / 2; ++j)
      EXPECT_EQ(key.angles[j].rad(), key.angles[j + actuator::kLegJoints / 2].rad());
}

}  // namespace
}  // namespace kelpie::learn
