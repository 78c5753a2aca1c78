// SPDX-License-Identifier: Apache-2.0
// Where everybody was 12 s before six goals of the team of 2005 against Kelpie: the ball, the
// attackers and the defenders, read from ../shared/data/rival/3s-RUN.csv.xz at the times below
// (the goals are those of its events, 12 s later). Turned so that the attack goes to y = 0 of a
// field of 363 by 542 cm, rounded to cm and degrees. Fails to say more than places: what everybody
// was about to do is not in it.
#pragma once

#include <array>

namespace kelpie::sim {

struct RivalPlace {
  double x, y, heading;  // cm, cm, deg
  bool off = false;      // serves a penalty beside the field
};

struct RivalAttack {
  std::array<double, 2> ball, velocity;       // cm, cm/s
  std::array<RivalPlace, 4> attack, defence;  // by player number
};

constexpr double kRivalWidth = 363.0, kRivalLength = 542.0;  // cm, of osaka2005
constexpr RivalPlace kOff{0.0, 0.0, 0.0, true};

constexpr std::array<RivalAttack, 6> kRivalAttacks = {{
    // 3s-m2-red_kelpie, 136.0 s
    {{277, 251},
     {-24, 18},
     {{{183, 518, -84}, {234, 396, -68}, {299, 244, -161}, kOff}},
     {{{191, 18, 63}, {311, 297, -127}, {286, 230, 90}, {62, 343, -14}}}},
    // 3s-m3-red_rival, 265.7 s
    {{103, 314},
     {18, -29},
     {{{170, 522, -113}, {76, 356, -72}, {42, 311, 91}, {59, 327, -92}}},
     {{{172, 18, 107}, {301, 294, 168}, {35, 289, 32}, {69, 229, 83}}}},
    // 3s-m5-red_kelpie, 246.8 s
    {{234, 216},
     {19, -38},
     {{{178, 507, -95}, {233, 225, -75}, {179, 213, 85}, {183, 342, -84}}},
     {{{185, 19, 83}, {107, 153, -101}, {214, 231, -5}, {179, 314, -129}}}},
    // 3s-m5-red_kelpie, 374.8 s
    {{205, 323},
     {-1, -43},
     {{kOff, {247, 426, -162}, {178, 391, -44}, {208, 335, -98}}},
     {{{187, 19, 79}, {328, 398, -115}, {113, 345, -39}, {230, 396, -121}}}},
    // 3s-h31-red_rival, 53.8 s
    {{182, 271},
     {0, 0},
     {{{174, 516, -92}, {175, 280, -60}, {125, 424, -59}, {293, 292, -48}}},
     {{{180, 23, 85}, {86, 233, 31}, {184, 122, 91}, {280, 229, 151}}}},
    // 3s-h31-red_rival, 305.3 s
    {{182, 271},
     {0, 0},
     {{{175, 526, -91}, {152, 373, -79}, {229, 380, -113}, {194, 402, -86}}},
     {{{180, 19, 89}, {183, 263, 93}, {149, 126, 72}, {262, 267, 131}}}},
}};

}  // namespace kelpie::sim
