// SPDX-License-Identifier: Apache-2.0
// What the game controller of the league broadcasts twice a second: the whole match, for both
// teams. Version 4, of 2005: facts-2005 section 8.3 for the header "RGme", states, penalties and
// team numbers; the order and width of the fields after the league's public structure of that
// version: thirty words of 32 bits, little endian.
//
//   byte    0  "RGme"           16  team that kicks off    24  team of the last drop-in
//           4  version          20  seconds left of half   28  seconds since it
//           8  state            32  one team, 44 bytes     76  the other
//          12  first half
//   a team  0  number            4  colour, 0 blue 1 red    8  score
//          12  four players: penalty, seconds until it ends
//
// Later versions add players per team and the colour of the goal and are refused by their number.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "robot/core/ControlPacket.h"
#include "robot/core/FrameInput.h"

namespace kelpie::net {

constexpr std::uint16_t kGameControlPort = 3838;  // UDP
constexpr std::uint32_t kGameControlVersion = 4;
constexpr std::size_t kGameControlSize = 120;  // bytes
constexpr std::size_t kControlPlayers = 4;     // of a team

// As they are numbered on the wire.
enum class ControlPenalty : std::uint8_t {
  none,
  ballHolding,
  goaliePushing,
  playerPushing,
  illegalDefender,
  illegalDefence,
  obstruction,
  requestForPickUp,
  leavingTheField,
  damage,
};

struct ControlPlayer {
  ControlPenalty penalty = ControlPenalty::none;
  std::uint32_t secondsLeft = 0;  // of the penalty

  static constexpr auto fields() {
    return fieldList(field("penalty", &ControlPlayer::penalty, "", 0, 9),
                     field("secondsLeft", &ControlPlayer::secondsLeft, "s", 0, 3600));
  }
};

struct ControlTeam {
  std::uint32_t number = 0;
  TeamColour colour = TeamColour::blue;
  std::uint32_t score = 0;
  std::array<ControlPlayer, kControlPlayers> players;

  static constexpr auto fields() {
    return fieldList(
        field("number", &ControlTeam::number), field("colour", &ControlTeam::colour, "", 0, 1),
        field("score", &ControlTeam::score, "", 0, 255), field("players", &ControlTeam::players));
  }
};

constexpr std::uint32_t kNoDropIn = 0xffffffff;  // seconds since one that has not been

struct GameControlData {
  PlayState state = PlayState::initial;
  bool firstHalf = true;
  TeamColour kickOff = TeamColour::blue;
  std::uint32_t secondsLeft = 0;  // of the half
  TeamColour dropInTeam = TeamColour::blue;
  std::uint32_t dropInSeconds = kNoDropIn;
  std::array<ControlTeam, 2> teams;

  static constexpr auto fields() {
    using D = GameControlData;
    return fieldList(field("state", &D::state, "", 0, 4), field("firstHalf", &D::firstHalf),
                     field("kickOff", &D::kickOff, "", 0, 1),
                     field("secondsLeft", &D::secondsLeft, "s", 0, 86400),
                     field("dropInTeam", &D::dropInTeam, "", 0, 1),
                     field("dropInSeconds", &D::dropInSeconds, "s"), field("teams", &D::teams));
  }
};

std::vector<std::uint8_t> encodeControl(const GameControlData& control);
ControlPacket packetOf(const GameControlData& control);

// Nothing and `control` is what the bytes say, or the first reason why not and `control` is left.
std::optional<ControlRefusal> decodeControl(const std::uint8_t* bytes, std::size_t size,
                                            GameControlData& control);

// The match as one robot's behaviours know it. `secondsLeft` is the half's in every state: the
// controller does not tell how long the ready state still is.
GameState gameStateFrom(const GameControlData& control, TeamColour team, std::uint8_t player);
// A match of which that robot would know so much: the way back, for what is recorded.
GameControlData controlFrom(const GameState& game);

}  // namespace kelpie::net
