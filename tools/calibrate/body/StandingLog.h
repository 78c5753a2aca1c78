// SPDX-License-Identifier: Apache-2.0
// The frames of a log in which a robot stood and its head rested: of its longest stand, those at
// least 0.3 s after the head came to a stop. Then neither the shutter's read-out nor an image that
// is older than its stamp matters, and the head has sunk through the play of its gears.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "robot/agent/AgentConfig.h"
#include "robot/core/Expected.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie::calibrate {

struct StandingFrame {
  FrameInput input;
  int stop = 0;                  // of the head, counted from 0
  std::size_t pan = 0;           // place in StandingLog::pans
  std::array<double, 3> head{};  // rad, neck tilt, pan and nod: mean of all that was sensed at rest
};

struct StandingLog {
  std::unique_ptr<agent::AgentConfig> config;  // as recorded
  std::vector<StandingFrame> frames;
  int stops = 0;
  std::vector<double> pans;  // rad, sensed, of all frames of the stand and those before it
  double seconds = 0.0;      // of the stand
  std::string lacks;         // what of the log could not be read; the other frames are taken
};

// An error says in one line why nothing can be estimated: no frames, no stand of 5 s, a head that
// does not rest, images that were not kept.
Expected<StandingLog> readStanding(const std::string& path);

}  // namespace kelpie::calibrate
