// SPDX-License-Identifier: Apache-2.0
// Runs the loops again on the inputs of a log and compares every output with the recorded one, bit
// for bit. A frame whose image was not kept goes on from its recorded percepts: everything but
// vision runs again. The same code on the PC and on the emulated target.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robot/agent/log/LoggedTypes.h"
#include "robot/agent/loops/FrameLoop.h"
#include "robot/agent/loops/MotionLoop.h"
#include "robot/core/log/LogReader.h"
#include "robot/core/log/LogTopics.h"

namespace kelpie::agent {

struct ReplayOptions {
  std::string scripts;          // folder or zip of behaviours
  std::uint32_t maxFrames = 0;  // 0: all
  // Changes the recorded configuration before the loops are made.
  std::function<void(AgentConfig&)> adjust;
  // Sees every frame; what it is given is valid during the call only.
  std::function<void(const FrameInput&, const FrameOutput&)> onFrame;
};

struct ReplayResult {
  std::uint32_t frames = 0;
  std::uint32_t framesFromPercepts = 0;  // of these, those whose image was not kept
  std::uint32_t motionSteps = 0;
  // Outputs found in the log and compared; behind damage none is, as what came before is missing.
  std::uint32_t compared = 0;
  std::uint32_t differing = 0;
  std::vector<std::string> differences;  // the first few, "frame 12: world.pose.x: 1 != 2"
  std::string lacks;                     // what of the log could not be read; empty: nothing
  std::string scriptError;
  std::vector<std::string> notes;  // of field lists other than today's (LogReader::notes)
};

// An error names file and place. Frames before it have been seen by onFrame.
Expected<ReplayResult> replay(const std::string& log, const ReplayOptions& options,
                              StageObserver& observer);

}  // namespace kelpie::agent
