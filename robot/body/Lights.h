// SPDX-License-Identifier: Apache-2.0
// What a robot's lights say to whoever watches a match. The one table:
//
//   above the ears  the game's state: initial none, ready blue, set red and green (yellow),
//                   playing green, finished red, green and blue (white); penalised red
//   the back        the team: red the rear, blue the front; the middle while the simple player
//                   plays, which a robot without Python has (robot/object)
//   the face        the role, one pair for each: attacker 1 and 2, supporter 3 and 4, striker 5
//                   and 6, defender 7 and 8, goalie 9 and 10
//   a fault         red above the ears goes on and off twice a second, which no state of the game
//                   does; as many lights of the face are lit as the fault's number, from the first
//
//   the face, low   why it does not play: it waits to be asked 11, is getting its gains 11 and 14;
//                   is lifted 12 and 14; paused 11 and 12, battery low 13, motors without power 13
//                   and 14, no image 14; the battery gives too much current 11 and 13, is too hot
//                   12 and 13, the fan stands still 11 to 13, a joint does not follow 12 to 14;
//                   none of it while it plays
//   the face, 12    the behaviours have failed in this frame: it stands and scans
//
//   the head, orange  the memory stick is being read; with the small blue one at the back of the
//                   head Python starts
//   the head, white  a light, an ear or a sensor does not open; the system's log names it
//   a fault, 14      a joint or the camera does not open, so that it cannot play
//
// The other lights are the behaviours' to use. Which light has which colour is stated in Tekkotsu's
// ERS7Info.h. Ready to penalised have the colours that the league's rules came to have; that
// initial shows none and finished white is chosen, so that no two are alike.
#pragma once

#include "robot/core/types/Command.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Motion.h"

namespace kelpie::body {

// Bits of every `leds` word, in the order of robot/openr/Ers7Primitives.h.
constexpr std::uint32_t kLightReading = 1U << 0U;  // of the head, orange
constexpr std::uint32_t kLightLacks = 1U << 1U;    // so, white
constexpr std::uint32_t kLightPython = 1U << 5U;   // at the back of the head, small and blue
constexpr std::uint32_t kLightRed = 1U << 2U;      // above both ears
constexpr std::uint32_t kLightGreen = 1U << 3U;    // so
constexpr std::uint32_t kLightBlue = 1U << 4U;     // so
constexpr std::uint32_t kLightBackFront = 1U << 20U;
constexpr std::uint32_t kLightBackMiddle = 1U << 22U;
constexpr std::uint32_t kLightBackRear = 1U << 24U;
constexpr std::uint32_t kFirstFaceLight = 6;
constexpr std::uint32_t kFaceLights = 14;
constexpr std::uint32_t kCrippledFault = 14;

std::uint32_t lightsOf(PlayState state, bool penalised);
std::uint32_t lightsOf(TeamColour team);
std::uint32_t lightsOf(Role role);
std::uint32_t lightsOf(Rest rest);
// For a line of the log.
const char* nameOf(Rest rest);
std::uint32_t lightsOf(Fallback fallback);

// What a robot shows that will not walk because of a fault; more than 14 show 14.
std::uint32_t faultLights(std::uint32_t number, TimeUs time);

// Game, team and role, and of what else was asked for the lights that the table does not use.
std::uint32_t lights(const GameState& game, Role role, std::uint32_t asked);
// Those of a robot that rests: game, team and why.
std::uint32_t lights(const GameState& game, Rest rest);

}  // namespace kelpie::body
