// SPDX-License-Identifier: Apache-2.0
// What is said to a process that was started.
#include <gtest/gtest.h>

#include <csignal>

#include "tools/cli/Process.h"

namespace kelpie::cli {
namespace {

TEST(Process, WhatIsSaidIsHeardLineByLine) {
  auto process = Process::start({"/bin/cat"}, true, true);
  ASSERT_TRUE(process) << process.error();
  EXPECT_TRUE(process->say("pause"));
  EXPECT_TRUE(process->say("ball 1,2"));
  std::string line;
  ASSERT_TRUE(process->readLine(line, 10000));
  EXPECT_EQ(line, "pause");
  ASSERT_TRUE(process->readLine(line, 10000));
  EXPECT_EQ(line, "ball 1,2");
}

TEST(Process, OneThatWasNotStartedToHearIsToldNothing) {
  auto process = Process::start({"/bin/sleep", "60"}, true);
  ASSERT_TRUE(process) << process.error();
  EXPECT_FALSE(process->say("pause"));
}

// Nobody waits for it, and no line arrives in part.
TEST(Process, OneThatHearsTooSlowlyMissesWholeLines) {
  auto process = Process::start({"/bin/sh", "-c", "read first; sleep 0.2; cat"}, true, true);
  ASSERT_TRUE(process) << process.error();
  ASSERT_TRUE(process->say("first"));
  const std::string words(100, 'w');
  int said = 0;
  while (said < 100000 && process->say(words)) ++said;
  EXPECT_GT(said, 10);
  EXPECT_LT(said, 100000);
  std::string line;
  for (int i = 0; i < said; ++i) {
    ASSERT_TRUE(process->readLine(line, 10000)) << i;
    ASSERT_EQ(line, words);
  }
  EXPECT_TRUE(process->say("last"));
  ASSERT_TRUE(process->readLine(line, 10000));
  EXPECT_EQ(line, "last");
}

TEST(Process, OneThatHasEndedHearsNothingAndHarmsNobody) {
  const auto before = std::signal(SIGPIPE, SIG_IGN);  // as every program of ours has it
  auto process = Process::start({"/bin/true"}, true, true);
  ASSERT_TRUE(process) << process.error();
  EXPECT_EQ(process->wait(), 0);
  EXPECT_FALSE(process->say("pause"));
  std::signal(SIGPIPE, before);
}

}  // namespace
}  // namespace kelpie::cli
