// SPDX-License-Identifier: Apache-2.0
// One robot against an empty goal in one process, from pixels to joints, every camera artefact on
// and the timing of a real match (sensors every 32 ms, images every 1/30 s, two command vectors in
// flight). After each image a watcher gets what the agent read and believed beside the truth of the
// same instant; the agent itself never sees the truth. The match has no end: after a goal the
// ball lies anywhere, so that the robot gets everywhere.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "robot/agent/loops/AgentLoops.h"
#include "robot/body/Ers7.h"
#include "robot/core/Random.h"
#include "tools/experiments/harness/Experiment.h"
#include "tools/sim/world/World.h"

namespace kelpie::experiments {

// The agent's default configuration for a kinematic or a physical body, changed by the experiment's
// parameter files.
Expected<agent::AgentConfig> agentConfig(const Request& request, bool physical = false);

struct WatchedFrame {
  const FrameInput& input;
  const FrameOutput& output;
  Pose2 truth;           // in the middle of the exposure: the time of the input
  Pose2 before;          // the truth of the frame before
  Point2<Field> ball;    // the truth, then
  double seconds = 0.0;  // that the frame took on this machine, by its clock
};

class LocaliseMatch : private agent::LogSink {
 public:
  using Watcher = std::function<void(const WatchedFrame&)>;

  // `scripts`: folder of behaviours. The config's field is the world's.
  LocaliseMatch(const agent::AgentConfig& config, const std::string& scripts, std::uint64_t seed,
                const cli::RandomisationOptions& randomised, bool physical = false);

  // Plays until that time; an error tells that the script broke.
  Status play(double seconds, const Watcher& watch);
  // The GameController halts play (PlayState::set) or lets it go on.
  void halt(bool halted) { halted_ = halted; }
  sim::World& world() { return *world_; }

 private:
  void frame(const FrameInput& input, const FrameOutput& output) override;
  void sense();
  void see(TimeUs now);
  void replaceBall();
  void send(const std::array<JointFrame, kTicksPerMessage>& joints, body::LegGain legs);

  body::FieldDescription field_;
  std::unique_ptr<sim::World> world_;
  std::unique_ptr<agent::AgentLoops> loops_;
  std::unique_ptr<Image> image_ = std::make_unique<Image>();
  std::uint32_t images_ = 0;  // the camera has taken
  Random random_;             // of the ball's places
  MotionInput motion_;
  Watcher watch_;
  Pose2 before_;
  std::chrono::steady_clock::time_point frameBegan_;
  bool seen_ = false;
  bool halted_ = false;
  std::string trouble_;
};

}  // namespace kelpie::experiments
