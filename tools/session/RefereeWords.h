// SPDX-License-Identifier: Apache-2.0
// A game controller in words, one line for each thing that a person at it would click:
//
//   initial  ready  set  playing  finished  half     states; half: the second half's initial
//   kickoff TEAM                                     whose the next one is
//   goal TEAM                                        counts it; ready, for the other team's
//   kick-off out TEAM                                         who touched it last: a drop-in
//   penalise TEAM PLAYER [REASON]                    reasons are holding, goalie, pushing,
//   defender,
//                                                    defence, obstruction, pickup, leaving, damage
//   back TEAM PLAYER                                 its penalty is over
//   wait SECONDS                                     nothing changes meanwhile
//   quit
//
// Clocks run by the time that the caller says has gone.
#pragma once

#include <string>

#include "robot/core/Expected.h"
#include "robot/net/GameControlData.h"

namespace kelpie::cli {

struct RefereeDesk {
  net::GameControlData control;
  double halfTime = 600.0;  // s
  double left = 600.0;      // s of the half
  double penaltyTime = 30.0;
  double sinceDropIn = 0.0;                                               // s
  std::array<std::array<double, net::kControlPlayers>, 2> penaltyLeft{};  // s, by control.teams
  double waits = 0.0;  // s that the next line has to wait
  bool quits = false;
};

// Teams as the controller numbers them.
RefereeDesk refereeDesk(std::uint32_t redNumber, std::uint32_t blueNumber, double halfTime);

// One line of words; an error says what is wrong with it, and nothing has changed. Empty lines and
// those that begin with # change nothing.
Status say(const std::string& line, RefereeDesk& desk);

// So much time has gone.
void goOn(double seconds, RefereeDesk& desk);

}  // namespace kelpie::cli
