// SPDX-License-Identifier: Apache-2.0
// The game controller's packets of later years, as far as their fields mean what those of version 4
// do. Layouts and numbers after the league's RoboCupGameControlData.h (docs/sources.md): version 8,
// of 2014 and 2015, and version 18, the newest of the league's program of today. Bytes, and halves
// of 16 bits in little endian.
//
//   version 8                                     version 18
//   byte  0  "RGme"                               byte  0  "RGme"
//         4  version, packet's number, players          4  version, packet's number, players
//         7  state, first half, team that kicks         7  phase and kind of competition, of game
//            off by colour                             10  state, set play, first half
//        10  second state, team of the drop-in         13  team that kicks, by its number
//        12  seconds since it, left, second time       14  seconds left, second time
//        18  one team, 70 bytes                        18  one team, 50 bytes
//        88  the other                                 68  the other
//   team  0  number, colour, score, shots         team  0  number, colour, keeper's colour
//         4  their bits                                 3  keeper, score, shots
//         6  coach's words (40), coach (2)              6  their bits, messages left
//        48  eleven players                            10  twenty players
//   a player: penalty, seconds until it ends
//
// A robot's team has four players here, so the first four count. What stands between (set plays
// while the ball is in play, shoot-outs, time-outs, whose state is initial) means nothing to a
// program of 2006. Standby, in which robots wait beside the field, is initial too.
#pragma once

#include <cstdint>
#include <optional>

#include "robot/core/types/ControlPacket.h"
#include "robot/net/ControlTypes.h"

namespace kelpie::net {

// The bytes are those of that version, as many as it has. A refusal leaves `control`.
std::optional<ControlRefusal> decodeVersion8(const std::uint8_t* bytes, GameControlData& control);
std::optional<ControlRefusal> decodeVersion18(const std::uint8_t* bytes, GameControlData& control);

}  // namespace kelpie::net
