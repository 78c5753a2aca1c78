// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/Version.h"

#include <fmt/core.h>

#include "robot/agent/log/LoggedTypes.h"
#include "robot/core/Checksum.h"
#include "robot/core/log/LogTopics.h"
#include "tools/cli/Commit.h"
#include "tools/sim/bodies/Randomisation.h"

namespace kelpie::cli {
namespace {

template <class T>
std::string described(const char* topic) {
  return std::string(topic) + "\n" + schemaName<T>() + "\n" + schemaText<T>() + "\n";
}

std::uint64_t fnv1a(const std::string& text) {
  Fnv1a hash;
  hash.add(text.data(), text.size());
  return hash.value();
}

}  // namespace

std::string fieldListVersion() {
  const std::string all =
      described<agent::AgentConfig>(kConfigTopic) + described<FrameInput>(kFrameInputTopic) +
      described<PlaneFrame>(kPlaneFrameTopic) + described<PictureFrame>(kPictureFrameTopic) +
      described<FrameOutput>(kFrameOutputTopic) + described<MotionInput>(kMotionInputTopic) +
      described<MotionOutput>(kMotionOutputTopic) + described<sim::TruthFrame>(sim::kTruthTopic) +
      described<sim::MatchEvent>(sim::kEventTopic) +
      described<sim::RandomisedWorld>(sim::kRandomisedTopic);
  return fmt::format("{:016x}", fnv1a(all));
}

std::string versionLine() {
  return fmt::format("kelpie {}, commit {}, field lists {}", projectVersion(), sourceCommit(),
                     fieldListVersion());
}

LogMap versionNotes() {
  return {{"version", projectVersion()},
          {"commit", sourceCommit()},
          {"field_lists", fieldListVersion()}};
}

}  // namespace kelpie::cli
