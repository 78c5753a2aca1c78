// SPDX-License-Identifier: Apache-2.0
// vision_fuzz FILE...               vision on a frame from each file's bytes
// vision_fuzz KIND FRAMES [SEED]    on hostile frames of a kind ("all": every one)
// Prints the largest counts; ends with 1 and a line when a percept is out of range. Under
// `valgrind --tool=callgrind --toggle-collect='kelpie::vision::step*'` it counts what a kind costs.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "robot/core/fields/FieldCheck.h"
#include "tests/vision/Hostile.h"
#include "vision/Vision.h"

namespace {

using namespace kelpie;
using namespace kelpie::vision;

struct Largest {
  std::uint32_t runs = 0;
  std::uint32_t blobs = 0;
  std::size_t looked = 0;
  unsigned refused = 0;
};

class Runner {
 public:
  bool run(const HostileFrame& frame, const std::string& what) {
    const Percepts seen = step({frame.input, frame.body}, {}, *state_);
    note(seen);
    std::string why;
    if (verify(seen, &why)) return true;
    std::fprintf(stderr, "vision_fuzz: %s: %s\n", what.c_str(), why.c_str());
    return false;
  }
  void print(const std::string& what) const {
    std::printf("%s: at most %u runs, %u blobs, %zu pixels looked at, %u refused\n", what.c_str(),
                largest_.runs, largest_.blobs, largest_.looked, largest_.refused);
  }

 private:
  void note(const Percepts& seen) {
    unsigned refused = 0;
    for (const auto count : seen.counts.refused) refused += count;
    std::size_t looked = 0;
    for (std::size_t i = 0; i < kImagePixels; ++i)
      looked += state_->classes.looked(i) != kNotLookedAt ? 1U : 0U;
    largest_ = {std::max(largest_.runs, seen.counts.runs),
                std::max(largest_.blobs, seen.counts.blobs), std::max(largest_.looked, looked),
                std::max(largest_.refused, refused)};
  }

  std::unique_ptr<VisionState> state_ = std::make_unique<VisionState>();
  Largest largest_;
};

bool runKind(std::size_t kind, int frames, std::uint64_t seed) {
  HostileFrames source(seed);
  Runner runner;
  bool good = true;
  const auto frame = std::make_unique<HostileFrame>();
  for (int i = 0; i < frames; ++i) {
    source.make(static_cast<HostileKind>(kind), *frame);
    good = runner.run(*frame, std::string(kHostileNames[kind]) + " " + std::to_string(i)) && good;
  }
  runner.print(kHostileNames[kind]);
  return good;
}

bool runFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const auto frame = std::make_unique<HostileFrame>();
  frameFromBytes(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), *frame);
  Runner runner;
  const bool good = in && runner.run(*frame, path);
  if (good) runner.print(path);
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string first = argc > 1 ? argv[1] : "";
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  bool good = argc > 1;
  bool known = false;
  for (std::size_t kind = 0; kind < kHostileKindCount && argc > 2; ++kind) {
    if (first != kHostileNames[kind] && first != "all") continue;
    known = true;
    good = runKind(kind, std::atoi(argv[2]), seed) && good;
  }
  for (int i = 1; i < argc && !known; ++i) good = runFile(argv[i]) && good;
  return good ? 0 : 1;
}
