// SPDX-License-Identifier: Apache-2.0
#include "robot/net/LaterControl.h"

#include "robot/net/ControlFields.h"

namespace kelpie::net {
namespace {

constexpr std::size_t kTeamsAt = 18;
constexpr std::size_t kPlayers8 = 11, kPlayers18 = 20;  // of a team
constexpr std::size_t kCoach = 42;                      // bytes
constexpr std::uint8_t kStandby = 5;
constexpr std::uint16_t kNever = 0xffff;  // has a ball been dropped in

ControlPenalty penalty8(std::uint8_t reported) {
  switch (reported) {
    case 0: return ControlPenalty::none;
    case 1: return ControlPenalty::ballHolding;
    case 2: return ControlPenalty::playerPushing;
    case 3: return ControlPenalty::obstruction;
    case 5: return ControlPenalty::illegalDefender;
    case 6: return ControlPenalty::leavingTheField;
    case 8: return ControlPenalty::requestForPickUp;
    default: return ControlPenalty::other;
  }
}

ControlPenalty penalty18(std::uint8_t reported) {
  switch (reported) {
    case 0: return ControlPenalty::none;
    case 1: return ControlPenalty::ballHolding;
    case 2: return ControlPenalty::playerPushing;
    case 6: return ControlPenalty::leavingTheField;
    case 7: return ControlPenalty::requestForPickUp;
    default: return ControlPenalty::other;
  }
}

// Whoever plays, comes first: robots off the bench have higher numbers.
void readPlayers(ControlBytes& in, std::size_t reported, ControlPenalty (*penalty)(std::uint8_t),
                 ControlTeam& team) {
  for (ControlPlayer& player : team.players) {
    player.penalty = penalty(in.byte());
    player.secondsLeft = in.byte();
  }
  in.skip(2 * (reported - team.players.size()));
}

void readTeams8(ControlBytes in, GameControlData& got) {
  std::array<std::uint32_t, 2> colours{};
  for (std::size_t i = 0; i < 2; ++i) {
    ControlTeam& team = got.teams[i];
    team.number = in.byte();
    colours[i] = in.byte();
    team.score = in.byte();
    in.skip(1 + 2 + kCoach);
    readPlayers(in, kPlayers8, penalty8, team);
  }
  setColours(colours, got);
}

void readTeams18(ControlBytes in, GameControlData& got) {
  std::array<std::uint32_t, 2> colours{};
  for (std::size_t i = 0; i < 2; ++i) {
    ControlTeam& team = got.teams[i];
    team.number = in.byte();
    colours[i] = in.byte();
    in.skip(2);
    team.score = in.byte();
    in.skip(1 + 2 + 2);
    readPlayers(in, kPlayers18, penalty18, team);
  }
  setColours(colours, got);
}

// By its number: nobody's when it is no team's, or both teams'.
void setKickingTeam(std::uint8_t number, GameControlData& got) {
  const bool first = got.teams[0].number == number;
  got.dropBall = first == (got.teams[1].number == number);
  got.kickOff = got.teams[first ? 0 : 1].colour;
}

}  // namespace

std::optional<ControlRefusal> decodeVersion8(const std::uint8_t* bytes, GameControlData& control) {
  GameControlData got;
  ControlBytes in(bytes + 7);
  const std::uint8_t state = in.byte();
  if (state > static_cast<std::uint8_t>(PlayState::finished)) return ControlRefusal::state;
  got.state = static_cast<PlayState>(state);
  got.firstHalf = in.byte() == 1;
  const std::uint8_t kickOff = in.byte();
  got.kickOff = kickOff == 1 ? TeamColour::red : TeamColour::blue;
  got.dropBall = kickOff > 1;
  in.skip(1);
  got.dropInTeam = in.byte() == 1 ? TeamColour::red : TeamColour::blue;
  const std::uint16_t dropIn = in.half();
  got.dropInSeconds = dropIn == kNever ? kNoDropIn : dropIn;
  got.secondsLeft = secondsFrom(static_cast<std::int16_t>(in.half()));
  readTeams8(ControlBytes(bytes + kTeamsAt), got);
  control = got;
  return std::nullopt;
}

std::optional<ControlRefusal> decodeVersion18(const std::uint8_t* bytes, GameControlData& control) {
  GameControlData got;
  ControlBytes in(bytes + 10);
  const std::uint8_t state = in.byte();
  if (state > kStandby) return ControlRefusal::state;
  got.state = state == kStandby ? PlayState::initial : static_cast<PlayState>(state);
  in.skip(1);
  got.firstHalf = in.byte() == 1;
  const std::uint8_t kicks = in.byte();
  got.secondsLeft = secondsFrom(static_cast<std::int16_t>(in.half()));
  readTeams18(ControlBytes(bytes + kTeamsAt), got);
  setKickingTeam(kicks, got);
  control = got;
  return std::nullopt;
}

}  // namespace kelpie::net
