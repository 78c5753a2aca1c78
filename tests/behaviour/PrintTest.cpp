// SPDX-License-Identifier: Apache-2.0
// What scripts print, what help() says, and what a script is advised to use in place of what it has
// not.
#include <gtest/gtest.h>

#include <algorithm>

#include "behaviour/interpreter/PrintedLines.h"
#include "tests/behaviour/Scripts.h"

namespace kelpie::behaviour {
namespace {

constexpr const char* kPlays = "\n    return kelpie.Command(motion=3)";

// What a first frame prints.
std::string printed(const std::string& body) {
  const Scripts scripts(body + kPlays);
  testing::internal::CaptureStderr();
  {
    HostRun run(scripts);
    EXPECT_EQ(run.step().motion, MotionKind::kickForward) << run.state.lastError();
  }
  return testing::internal::GetCapturedStderr();
}

std::string failed(const std::string& body) {
  const Scripts scripts(body + kPlays);
  HostRun run(scripts);
  EXPECT_EQ(run.step().fallback, Fallback::scriptError);
  return run.state.lastError();
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Print, LineGoesToTheConsoleAndTheRobotPlays) {
  EXPECT_EQ(printed("print('ball', 12.5, None)"), "behaviour: ball 12.5 None\n");
}

TEST(Print, EndAndSeparatorAreThoseOfPython) {
  EXPECT_EQ(printed("print(1, 2, sep='-', end=';'); print(3); print('a\\nb')"),
            "behaviour: 1-2;3\nbehaviour: a\nbehaviour: b\n");
}

TEST(Print, LineIsReportedToTheRobotsLogAsNoFault) {
  const Scripts scripts("print('hello')" + std::string(kPlays));
  HostRun run(scripts);
  run.step();
  std::uint32_t read = 0;
  const ReportLine* const line = run.state.reports().next(read);
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->text, "hello");
  EXPECT_FALSE(line->fault);
  EXPECT_EQ(run.state.reports().next(read), nullptr);
}

TEST(Print, MoreThanTenLinesASecondAreCountedAndReported) {
  const Scripts scripts("print('frame', world.frame)" + std::string(kPlays));
  testing::internal::CaptureStderr();
  {
    HostRun run(scripts);
    for (int i = 0; i < 70; ++i) run.step();
  }
  const std::string reported = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(reported.begin(), reported.end(), '\n'), 10 + 1 + 10 + 1 + 10 + 1)
      << reported;
  EXPECT_TRUE(contains(reported,
                       "behaviour: frame 10\nbehaviour: print(): 19 more lines; 10 a second "
                       "are shown\nbehaviour: frame 30\n"))
      << reported;
}

TEST(Print, LongLineIsCutBetweenTwoCharactersAndSaysHowMuchIsMissing) {
  const std::string line = printed("print('x' + '\\u00e4' * 10000)");
  EXPECT_TRUE(contains(line, "\xc3\xa4... (19802 bytes more)\n")) << line;
  EXPECT_EQ(PrintedLines().shown(std::string(200, 'y')), std::string(200, 'y'));
}

TEST(Print, WhatSteersATerminalIsShownAsAQuestionMark) {
  EXPECT_EQ(printed("print('a\\x1b[2Jb\\rc\\0d')"), "behaviour: a?[2Jb?c?d\n");
}

TEST(Print, LineThatDoesNotEndIsReportedInTheEnd) {
  EXPECT_EQ(printed("for i in range(1500): print('.', end='')").size(),
            std::string("behaviour: ").size() + 200 + std::string("... (801 bytes more)\n").size());
}

TEST(Print, WhatIsPrintedWhileLoadingIsReportedToo) {
  const Scripts scripts;
  testing::internal::CaptureStderr();
  scripts.write("main.py", "print('loads')\ndef decide(world): pass\n");
  const HostRun run(scripts);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "behaviour: loads\n");
}

TEST(Help, FunctionsTellTheirArgumentsAndDocstring) {
  EXPECT_EQ(
      printed("def walk(far, wide=1):\n        '''Goes on.\n\n        Far.'''\n    help(walk)"),
      "behaviour: walk(far, wide)\nbehaviour:   Goes on.\nbehaviour:   Far.\n");
}

TEST(Help, WorldTellsItsNames) {
  const std::string reported = printed("help(world)");
  for (const char* name : {"ball", "time_s", "teammates", "pose"})
    EXPECT_TRUE(contains(reported, name));
}

TEST(Help, LongDocstringIsBounded) {
  const std::string reported = printed("help(str)");
  EXPECT_EQ(std::count(reported.begin(), reported.end(), '\n'), 9) << reported;
  EXPECT_TRUE(contains(reported, "more lines\n")) << reported;
}

TEST(Instead, MissingModuleSaysWhatThereIs) {
  EXPECT_TRUE(contains(failed("import random"), "not 'random': nothing is random"));
  EXPECT_TRUE(contains(failed("import os.path"), "not 'os': there are no files"));
  EXPECT_TRUE(contains(failed("from time import sleep"), "not 'time': world.time_s is the time"));
  EXPECT_TRUE(contains(failed("import socket"), "not 'socket': mates hear Command.team"));
  EXPECT_TRUE(contains(failed("import numpy"), "not 'numpy': lists and math"));
  EXPECT_TRUE(contains(failed("from skills import nothing"), "not 'skills'"));
}

TEST(Instead, MissingFunctionSaysWhatThereIs) {
  EXPECT_TRUE(contains(failed("open('x')"), "name 'open' is not defined: there are no files"));
  EXPECT_TRUE(contains(failed("x = unknown"), "name 'unknown' is not defined"));
}

}  // namespace
}  // namespace kelpie::behaviour
