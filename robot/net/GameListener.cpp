// SPDX-License-Identifier: Apache-2.0
#include "robot/net/GameListener.h"

#include <limits>
#include <optional>

namespace kelpie::net {
namespace {

void count(std::uint32_t& number) {
  if (number < std::numeric_limits<std::uint32_t>::max()) ++number;
}

bool has(const ControlTeam& team, int number) {
  return number >= 0 && team.number == static_cast<std::uint32_t>(number);
}

// Where no colours were given the number says which team is the robot's.
void setColoursByNumber(TeamColour team, int number, GameControlData& control) {
  if (control.coloursGiven) return;
  const std::size_t own = control.teams[0].colour == team ? 0 : 1;
  if (!has(control.teams[own], number) && has(control.teams[1 - own], number)) swapColours(control);
}

// The uniform says which colour a robot has: a packet that gives its team the other one is not of
// this match.
bool isForeign(const GameControlData& control, TeamColour team, int number) {
  if (number < 0) return false;
  for (const ControlTeam& one : control.teams)
    if (one.colour == team) return !has(one, number);
  return true;
}

bool isSilent(TimeUs now, const ListenerParams& params, const ListenerState& state) {
  return !state.heard || (now - state.last).seconds() >= params.silence;
}

}  // namespace

ListenerState listenerFor(TeamColour team, std::uint8_t player) {
  ListenerState state;
  state.game.state = PlayState::initial;
  state.game.team = team;
  state.game.player = player;
  return state;
}

void hear(const ControlPacket& packet, TimeUs now, const ListenerParams& params,
          ListenerState& state) {
  GameControlData control;
  auto refusal = decodeControl(packet.bytes.begin(), packet.bytes.size(), control);
  if (!refusal) setColoursByNumber(state.game.team, params.teamNumber, control);
  if (!refusal && isForeign(control, state.game.team, params.teamNumber))
    refusal = ControlRefusal::foreign;
  if (refusal) return count(state.counts.refused[static_cast<std::size_t>(*refusal)]);
  count(state.counts.taken);
  state.heard = true;
  state.last = now;
  state.game = gameStateFrom(control, state.game.team, state.game.player);
}

void feel(const ButtonIn& in, const ListenerParams& params, ListenerState& state) {
  GameState& game = state.game;
  state.buttons.play = game.state;
  state.buttons.penalised = game.penalised;
  const ButtonGame pressed = step(in, params.buttons, state.buttons);
  if (!isSilent(in.time, params, state)) return;
  if (game.state != pressed.state) game.kickOff = false;  // no button tells whose it is
  game.state = pressed.state;
  game.penalised = pressed.penalised;
}

}  // namespace kelpie::net
