// SPDX-License-Identifier: Apache-2.0
// kelpie-target LOG --pycode ZIP_OR_DIR [--limit N]
// Replays a log through the camera loop and the motion loop and compares every output with the
// recorded one, bit for bit. Exit code 0: all equal, 1: something differs or cannot be compared,
// 2: bad input. On the target the zip must bring Python's `encodings` (toolchain/make-pyzip).
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>

#include "robot/agent/log/Replay.h"
#include "toolchain/target/StageMarkers.h"

namespace {

using kelpie::agent::ReplayResult;

constexpr int kEqual = 0;
constexpr int kDiffers = 1;
constexpr int kBadInput = 2;

struct Options {
  std::string log;
  std::string pycode;
  std::uint32_t limit = 0;  // frames, 0: all
};

std::optional<std::uint32_t> countOf(const char* text) {
  char* end = nullptr;
  errno = 0;
  const unsigned long value = std::strtoul(text, &end, 10);
  const bool digits = *text >= '0' && *text <= '9' && *end == '\0';
  if (!digits || errno != 0 || value == 0 || value > 0x7fffffffUL) return std::nullopt;
  return static_cast<std::uint32_t>(value);
}

// One line that says what is wrong with the arguments, empty if nothing is.
std::string parse(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const bool named = argument.compare(0, 2, "--") == 0;
    if (!named && options.log.empty()) {
      options.log = argument;
      continue;
    }
    if (argument != "--pycode" && argument != "--limit") return "unknown argument " + argument;
    if (i + 1 == argc) return argument + " needs a value";
    const char* value = argv[++i];
    if (argument == "--pycode") {
      options.pycode = value;
      continue;
    }
    const auto limit = countOf(value);
    if (!limit) return std::string("--limit needs a number of frames from 1 on, not ") + value;
    options.limit = *limit;
  }
  if (options.log.empty() || options.pycode.empty())
    return "usage: kelpie-target LOG --pycode ZIP_OR_DIR [--limit N]";
  return {};
}

int complain(const std::string& line) {
  std::fprintf(stderr, "kelpie-target: %s\n", line.c_str());
  return kBadInput;
}

int report(const Options& options, const ReplayResult& result) {
  for (const std::string& line : result.differences)
    std::fprintf(stderr, "kelpie-target: %s\n", line.c_str());
  if (!result.scriptError.empty())
    std::fprintf(stderr, "kelpie-target: %s\n", result.scriptError.c_str());
  std::printf("replayed %u frames, %u differ (%u motion steps, %u outputs compared)\n",
              result.frames, result.differing, result.motionSteps, result.compared);
  if (!result.lacks.empty())
    return complain(options.log + ": " + result.lacks + "; the whole frames were replayed");
  if (result.compared == 0) {
    complain(options.log + ": holds no outputs to compare with");
    return kDiffers;
  }
  return result.differing == 0 ? kEqual : kDiffers;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  const std::string wrong = parse(argc, argv, options);
  if (!wrong.empty()) return complain(wrong);
  std::FILE* const scripts = std::fopen(options.pycode.c_str(), "rb");
  if (scripts == nullptr) return complain(options.pycode + ": " + std::strerror(errno));
  std::fclose(scripts);

  kelpie::agent::ReplayOptions replay;
  replay.scripts = options.pycode;
  replay.maxFrames = options.limit;
  // Emulation is slower than the recording machine; a limit in CPU seconds would cut good scripts.
  replay.adjust = [](kelpie::agent::AgentConfig& config) { config.behaviour.timeLimit = 10.0; };
  kelpie::target::StageMarkers markers;
  const auto result = kelpie::agent::replay(options.log, replay, markers);
  if (!result) return complain(result.error());
  return report(options, *result);
}
