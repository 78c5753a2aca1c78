// SPDX-License-Identifier: Apache-2.0
// Scenes for the rules' tests: players by hand on the 2006 field, and time that goes on.
#pragma once

#include "tools/sim/rules/MatchScene.h"

namespace kelpie::sim {

constexpr auto kRed = TeamColour::red;
constexpr auto kBlue = TeamColour::blue;

inline body::FieldDescription ruleField() { return *body::fieldDescription("2006"); }

struct MadeScene : MatchScene {
  MadeScene() { ball = {{180.0, 270.0}, {}}; }

  MadeScene& with(TeamColour team, std::uint8_t number, Point2<Field> place,
                  double heading_deg = 90.0) {
    players.push_back({team, number, {place, Angle::deg(heading_deg)}, true, true});
    return *this;
  }
  // Calls f(*this) for every tick of so many seconds.
  template <class F>
  void goesOn(double seconds, F&& f) {
    const auto ticks = static_cast<int>(seconds / kTickSeconds + 0.5);
    for (int i = 0; i < ticks; ++i) {
      time = time + TimeUs{kTickUs};
      f(*this);
    }
  }
  // So many seconds of a step that calls fouls; those that it called.
  template <class F>
  std::size_t callsIn(double seconds, F&& f) {
    std::size_t calls = 0;
    goesOn(seconds, [&](MadeScene& scene) { calls += f(scene).size(); });
    return calls;
  }
};

}  // namespace kelpie::sim
