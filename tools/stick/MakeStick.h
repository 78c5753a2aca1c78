// SPDX-License-Identifier: Apache-2.0
// A stick's whole tree, made of a configuration, a program, behaviours and a radio's settings, and
// checked by the reader that the robot has.
#pragma once

#include "robot/agent/AgentConfig.h"
#include "robot/core/Expected.h"
#include "tools/stick/StickTree.h"

namespace kelpie::stick {

// What beside the configuration goes onto a stick.
struct StickContents {
  std::string object;       // AGENT.BIN; empty: the stick lacks it
  std::string behaviours;   // the zip of toolchain/make-pyzip
  std::string wlan;         // WLANCONF.TXT; empty: that of the stick stays
  bool relaxedJams = true;  // VRCOMM.CFG; else that of the stick stays, or there is none
};

// A programming stick holds 8 MB at least, and Sony's system on it 1.21 MB at most (spec openr.md
// section 6); 0.3 MB are left for the file system and a crash's EMON.LOG.
constexpr std::size_t kLargestTree = 6500000;

// All files, checked: names in 8.3, the sum within kLargestTree, and loaded back with the robot's
// own reader into the same configuration, bit for bit.
Expected<StickTree> makeTree(const agent::AgentConfig& config, const StickContents& contents);

// Whether the reader gives that configuration back; else one line.
Status verifyStick(StickFiles& files, const agent::AgentConfig& config);

}  // namespace kelpie::stick
