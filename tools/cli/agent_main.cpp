// SPDX-License-Identifier: Apache-2.0
// kelpie-agent: one robot's brain as a process. Talks to a simulated world through the
// OPEN-R-shaped services and writes its log. `kelpie play` starts it; by hand it joins any
// kelpie-world.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <optional>

#include "robot/agent/AgentLoops.h"
#include "robot/host/RunAgent.h"
#include "tools/cli/Config.h"
#include "tools/cli/Describe.h"
#include "tools/cli/Logs.h"
#include "tools/cli/Process.h"

namespace kelpie::cli {
namespace {

constexpr std::uint32_t kStatusFrames = 15;  // twice a simulated second

struct AgentOptions {
  std::string socket;
  std::string log;
  std::string pycode = defaultScripts();
  double dropRate = 0.0;
  std::uint64_t seed = 1;
  bool status = false;
  ConfigOptions config;
};

// Passes frames on to the log, if there is one, and says now and then what the robot believes.
class AgentSink : public agent::LogSink {
 public:
  AgentSink(LogFile* log, bool status) : log_(log), status_(status) {}
  void motion(const MotionInput& input, const MotionOutput& output) override {
    if (log_ != nullptr) log_->motion(input, output);
  }
  void frame(const FrameInput& input, const FrameOutput& output) override {
    if (log_ != nullptr) log_->frame(input, output);
    if (!status_ || input.frame % kStatusFrames != 0) return;
    fmt::print("{}\n", describe(output));
    std::fflush(stdout);
  }

 private:
  LogFile* log_;
  bool status_;
};

int fail(const std::string& message, int code) {
  fmt::print(stderr, "kelpie-agent: {}\n", message);
  return code;
}

int run(const AgentOptions& options) {
  const auto config = makeConfig(options.config);
  if (!config) return fail(config.error(), 2);
  std::optional<LogFile> log;
  if (!options.log.empty()) {
    auto created = LogFile::create(options.log, *config);
    if (!created) return fail(created.error(), 2);
    log.emplace(std::move(*created));
  }
  AgentSink sink(log ? &*log : nullptr, options.status);
  agent::AgentLoops loops(*config, options.pycode, sink);
  const Status played = play(options, *config, loops);
  const Status closed = log ? log->close() : Status(Done{});
  if (!played) return fail(played.error(), 1);
  return closed ? 0 : fail(closed.error(), 1);
}

}  // namespace
}  // namespace kelpie::cli
