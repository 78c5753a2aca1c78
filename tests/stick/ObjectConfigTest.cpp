// SPDX-License-Identifier: Apache-2.0
// What OPEN-R reads of the object, against what was measured of it.
#include <sstream>

#include "tests/stick/Sticks.h"

namespace kelpie::stick {
namespace {

// What toolchain/check-object allows the deepest path of calls, outside Python's interpreter and in
// it; beyond them the system's own functions take what nobody knows.
constexpr double kDeepestPath = 60 * 1024 + 96256;
// What toolchain/emulate tells of 300 frames with Python.
constexpr double kHeapTaken = 4077385;

struct ObjectConfig {
  std::string word, name;
  double stack = 0.0;
  double heap = 0.0;
  int priority = 0;
  std::string cache, tlb, mode;
};

ObjectConfig readObjectConfig() {
  std::istringstream lines(*readWhole(KELPIE_SOURCE_DIR "/robot/object/agent.ocf"));
  std::string line;
  while (std::getline(lines, line) && line.rfind('#', 0) == 0) {
  }
  ObjectConfig config;
  std::istringstream(line) >> config.word >> config.name >> config.stack >> config.heap >>
      config.priority >> config.cache >> config.tlb >> config.mode;
  return config;
}

TEST(ObjectConfig, GivesMoreStackAndHeapThanWereMeasured) {
  const ObjectConfig config = readObjectConfig();
  EXPECT_EQ(config.word, "object");
  EXPECT_EQ(config.name, "Agent");
  EXPECT_GE(config.stack, 2 * kDeepestPath);
  EXPECT_GT(config.heap, 1.15 * kHeapTaken);
  EXPECT_EQ(config.priority, 128);
  EXPECT_EQ(config.mode, "kernel");
}

// Every service that the stub has is joined, with the same type on both sides.
TEST(ConnectConfig, JoinsEveryServiceOfTheStub) {
  const StickTree tree = sampleTree();
  const std::string& connections = findFile(tree, kConnectPath)->bytes;
  std::istringstream lines(*readWhole(KELPIE_SOURCE_DIR "/robot/openr/stub/stub.cfg"));
  std::string line;
  int services = 0;
  while (std::getline(lines, line)) {
    const auto quote = line.find('"');
    if (line.rfind("Service", 0) != 0) continue;
    const std::string service = line.substr(quote + 1, line.find('"', quote + 1) - quote - 1);
    EXPECT_NE(connections.find("Agent" + service.substr(service.find('.'))), std::string::npos)
        << service;
    ++services;
  }
  EXPECT_EQ(services, 3);
  std::istringstream pairs(connections);
  std::string from;
  std::string to;
  for (int pair = 0; pairs >> from >> to; ++pair) {
    const auto type = [](const std::string& name) {
      const auto end = name.rfind('.');
      const auto start = name.rfind('.', end - 1);
      return name.substr(start, end - start);
    };
    EXPECT_EQ(type(from), type(to));
    EXPECT_EQ(from.back(), 'S');
    EXPECT_EQ(to.back(), 'O');
  }
}

}  // namespace
}  // namespace kelpie::stick
