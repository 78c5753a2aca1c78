// SPDX-License-Identifier: Apache-2.0
// What a robot hears of its team: packets become messages with an age, and what is no packet of the
// team is counted by its reason. Keeps of each mate the last number and how far its clock is ahead:
// no two robots' clocks agree, so the quickest packet so far is taken to have been under way for
// kQuickest, and others for as much longer as they came later. A mate whose numbers begin anew, or
// whose clock jumps, has restarted.
#pragma once

#include <array>

#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Radio.h"

namespace kelpie::net {

constexpr double kQuickest = 0.02;  // s under way at least: half a message of sensors, and the air
constexpr double kLatest = 1.0;     // s; what was under way for longer is of no use
constexpr double kRestart = 5.0;    // s; a clock that jumps by more is another one

struct MateClock {
  bool known = false;
  std::uint16_t number = 0;  // of the last message
  std::int64_t min = 0;      // us: own clock at the arrival less the sender's, at the quickest
  TimeUs heard;              // own clock, of the last packet
};

struct RadioState {
  std::array<MateClock, kTeammates + 1> mates{};  // by player number less one
  RadioCounts counts;
};

// Takes one packet that arrived now. Puts its message beside the others of this frame, in place of
// an older one of the same mate.
void hear(const RadioPacket& packet, TimeUs now, TeamColour team, std::uint8_t player,
          RadioState& state, FixedVector<TeamMessage, kTeammates>& messages);

}  // namespace kelpie::net
