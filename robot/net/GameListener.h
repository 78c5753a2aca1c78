// SPDX-License-Identifier: Apache-2.0
// The match as one robot knows it: by the game controller's packets, and where none has come for
// long by its buttons. What changes nothing is counted by its reason. While the controller is heard
// buttons have no effect; when it falls silent the last state holds, and buttons go on from there;
// the next packet rules again. Before the first packet the state is `initial`, as of a robot that
// was just switched on.
#pragma once

#include "robot/core/types/ControlPacket.h"
#include "robot/net/ButtonGame.h"
#include "robot/net/GameControlData.h"

namespace kelpie::net {

// The hand that carries a robot off presses its back, which is not to bring it back into play.
constexpr ButtonParams headAdvances() {
  ButtonParams params;
  params.backAdvances = false;
  return params;
}

struct ListenerParams {
  // Of the own team as the controller numbers teams; -1: packets of any two teams are for this
  // robot.
  int teamNumber = -1;
  double silence =
      3.0;  // s without a packet until buttons count; the controller sends two a second
  ButtonParams buttons = headAdvances();

  template <int = 0>
  static constexpr auto fields() {
    using P = ListenerParams;
    return fieldList(field("teamNumber", &P::teamNumber, "", -1, 1e6),
                     field("silence", &P::silence, "s", 0.5, 600), field("buttons", &P::buttons));
  }
};

struct ListenerState {
  GameState game;  // team and player are the robot's, from the start
  bool heard = false;
  TimeUs last;  // packet that was taken
  ButtonState buttons;
  ControlCounts counts;
};

ListenerState listenerFor(TeamColour team, std::uint8_t player);

// Takes what has arrived now.
void hear(const ControlPacket& packet, TimeUs now, const ListenerParams& params,
          ListenerState& state);
// Takes what the sensors feel, one tick after the other.
void feel(const ButtonIn& in, const ListenerParams& params, ListenerState& state);

}  // namespace kelpie::net
