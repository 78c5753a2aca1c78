// SPDX-License-Identifier: Apache-2.0
// stick-hash DIR: reads a stick as the robot does, and prints what the reader says of it and one
// number of the configuration. The PC's and the target's must be equal. Exit code 1: refused.
#include <cstdio>
#include <memory>
#include <vector>

#include "robot/core/fields/Encoding.h"
#include "robot/stick/StdioFiles.h"
#include "robot/stick/StickReader.h"

namespace {

std::uint64_t hashOf(const kelpie::agent::AgentConfig& config) {
  std::vector<std::uint8_t> bytes;
  kelpie::encode(config, bytes);
  kelpie::Fnv1a hash;
  hash.add(bytes.data(), bytes.size());
  return hash.value();
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: stick-hash DIR\n");
    return 2;
  }
  kelpie::stick::StdioFiles files(words[1]);
  const auto reader = std::make_unique<kelpie::stick::StickReader>(files);
  const auto config = std::make_unique<kelpie::agent::AgentConfig>();
  const kelpie::stick::StickVerdict verdict = reader->load(*config);
  const auto line = kelpie::stick::lineOf(verdict);
  std::printf("%.*s\n", static_cast<int>(line.size()), line.view().data());
  if (!verdict.good()) return 1;
  std::printf("%016llx\n", static_cast<unsigned long long>(hashOf(*config)));
  return 0;
}
