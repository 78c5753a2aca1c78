// SPDX-License-Identifier: Apache-2.0
// What the game controller of the league broadcasts twice a second: the whole match, for both
// teams. Version 4, of 2005, is what Kelpie itself sends: facts-2005 section 8.3 for the header
// "RGme", states, penalties and team numbers; the order and width of the fields after the league's
// public structure of that version: thirty words of 32 bits, little endian.
//
//   byte    0  "RGme"           16  team that kicks off    24  team of the last drop-in
//           4  version          20  seconds left of half   28  seconds since it
//           8  state            32  one team, 44 bytes     76  the other
//          12  first half
//   a team  0  number            4  colour, 0 blue 1 red    8  score
//          12  four players: penalty, seconds until it ends
//
// Versions 8 and 18, which people still have programs for, are understood as well (LaterControl.h).
// Every other is refused by its number. Whatever a field says that cannot be costs that field
// alone, for a match whose clock is wrong still has a state and penalties; only a state that nobody
// knows costs the packet.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/core/types/ControlPacket.h"
#include "robot/net/ControlTypes.h"

namespace kelpie::net {

constexpr std::uint16_t kGameControlPort = 3838;  // UDP
constexpr std::uint32_t kGameControlVersion = 4;
constexpr std::size_t kGameControlSize = 120;  // bytes

// What is understood, and how many bytes it has.
struct ControlLayout {
  std::uint32_t version;
  std::size_t size;
};
constexpr ControlLayout kControlLayouts[] = {
    {kGameControlVersion, kGameControlSize}, {8, 158}, {18, 118}};

// The version that a game controller's packet of any age tells; nothing for other bytes.
std::optional<std::uint32_t> controlVersion(const std::uint8_t* bytes, std::size_t size);

std::vector<std::uint8_t> encodeControl(const GameControlData& control);
ControlPacket packetOf(const GameControlData& control);

// The other way round, as for a robot who knows its team by number and not by colour.
void swapColours(GameControlData& control);

// Nothing and `control` is what the bytes say, or the first reason why not and `control` is left.
std::optional<ControlRefusal> decodeControl(const std::uint8_t* bytes, std::size_t size,
                                            GameControlData& control);

// The match as one robot's behaviours know it. `secondsLeft` is the half's in every state: the
// controller does not tell how long the ready state still is.
GameState gameStateFrom(const GameControlData& control, TeamColour team, std::uint8_t player);
// A match of which that robot would know so much: the way back, for what is recorded.
GameControlData controlFrom(const GameState& game);

}  // namespace kelpie::net
