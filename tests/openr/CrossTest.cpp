// SPDX-License-Identifier: Apache-2.0
// What a PC cannot tell of an object for the robot: its sizes, and whether it compiles where
// pointers and `long` have 32 bits and there are neither exceptions nor RTTI. Skipped, and says so,
// where there is no compiler for mipsel (Debian: g++-mipsel-linux-gnu).
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace kelpie::openr {
namespace {

constexpr const char* kCompiler = "mipsel-linux-gnu-g++";

// The house's warnings and the robot's flags (openr.md 3.2).
constexpr const char* kFlags =
    " -std=c++17 -march=mips2 -fno-exceptions -fno-rtti -fsyntax-only -Wall -Wextra -Werror"
    " -Wconversion -Wshadow -Wdouble-promotion -I. -I" KELPIE_GENERATED
    " -Irobot/openr/include -Irobot/openr/stub -x "
    "c++ ";

constexpr const char* kShape = "-include tests/openr/RobotShape.h /dev/null";

bool hasCompiler() {
  const std::string asks = std::string("command -v ") + kCompiler + " >/dev/null 2>&1";
  return std::system(asks.c_str()) == 0;
}

// What the compiler says of a file of the repository; nothing when it is content.
std::string saidOf(const std::string& file, const std::string& more = "") {
  const std::string line =
      std::string("cd " KELPIE_SOURCE_DIR " && ") + kCompiler + kFlags + more + file + " 2>&1";
  std::string said;
  std::FILE* pipe = popen(line.c_str(), "r");
  if (pipe == nullptr) return "the compiler cannot be run";
  std::array<char, 512> part;
  while (std::fgets(part.data(), part.size(), pipe) != nullptr) said += part.data();
  const int status = pclose(pipe);
  return status == 0 && said.empty() ? "" : said + "exit " + std::to_string(WEXITSTATUS(status));
}

class Cross : public testing::Test {
 protected:
  void SetUp() override {
    if (!hasCompiler()) GTEST_SKIP() << "no " << kCompiler;
  }
};

TEST_F(Cross, TheStandInHasTheSizesOfTheRobot) { EXPECT_EQ("", saidOf(kShape)); }

TEST_F(Cross, TheAgentCompilesForTheRobotWithoutAWarning) {
  EXPECT_EQ("", saidOf("robot/agent/Agent.cpp"));
  EXPECT_EQ("", saidOf("robot/agent/AgentIo.cpp"));
  EXPECT_EQ("", saidOf("robot/agent/AntEndpoint.cpp"));
  EXPECT_EQ("", saidOf("robot/agent/AntRadio.cpp"));
}

// So that an empty answer means something.
TEST_F(Cross, AWrongSizeIsRefused) {
  const std::string said = saidOf(kShape, "-fpack-struct=1 ");
  EXPECT_NE(std::string::npos, said.find("static assertion failed")) << said;
}

}  // namespace
}  // namespace kelpie::openr
