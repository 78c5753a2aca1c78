// SPDX-License-Identifier: Apache-2.0
// The match as a game controller tells it, as plain data: for both teams, four players each.
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/types/FrameInput.h"

namespace kelpie::net {

constexpr std::size_t kControlPlayers = 4;  // of a team

// As version 4 numbers them on the wire.
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
  other,  // one that version 4 does not have
};

struct ControlPlayer {
  ControlPenalty penalty = ControlPenalty::none;
  std::uint32_t secondsLeft = 0;  // of the penalty

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("penalty", &ControlPlayer::penalty, "", 0, 10),
                     field("secondsLeft", &ControlPlayer::secondsLeft, "s", 0, 3600));
  }
};

struct ControlTeam {
  std::uint32_t number = 0;
  TeamColour colour = TeamColour::blue;
  std::uint32_t score = 0;
  std::array<ControlPlayer, kControlPlayers> players;

  template <int = 0>
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
  bool dropBall = false;          // nobody kicks off
  std::uint32_t secondsLeft = 0;  // of the half
  TeamColour dropInTeam = TeamColour::blue;
  std::uint32_t dropInSeconds = kNoDropIn;
  std::array<ControlTeam, 2> teams;
  // False: announced were not one blue and one red team, so that the first is blue here and the
  // second red. Who knows its team's number knows better.
  bool coloursGiven = true;

  template <int = 0>
  static constexpr auto fields() {
    using D = GameControlData;
    return fieldList(field("state", &D::state, "", 0, 4), field("firstHalf", &D::firstHalf),
                     field("kickOff", &D::kickOff, "", 0, 1), field("dropBall", &D::dropBall),
                     field("secondsLeft", &D::secondsLeft, "s", 0, 86400),
                     field("dropInTeam", &D::dropInTeam, "", 0, 1),
                     field("dropInSeconds", &D::dropInSeconds, "s"), field("teams", &D::teams),
                     field("coloursGiven", &D::coloursGiven));
  }
};

}  // namespace kelpie::net
