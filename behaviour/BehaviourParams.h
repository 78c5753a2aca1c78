// SPDX-License-Identifier: Apache-2.0
// What can be tuned in the host of the behaviours: not how the robot plays, which is in pycode/.
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/Angle.h"
#include "robot/core/Fields.h"

namespace kelpie::behaviour {

// The player: it plays against a goal, or the 2004 localisation challenge (thesis 2004
// section 4.1).
enum class PlayerKind : std::uint8_t { striker, challenger };
constexpr std::uint8_t kPlayerKindCount = 2;

// The part of `world` that is fixed before the match.
struct Task {
  PlayerKind player = PlayerKind::striker;
  std::array<double, 10> points{};  // cm on the field: x, y of the challenge's five points

  static constexpr auto fields() {
    return fieldList(field("player", &Task::player, "", 0, kPlayerKindCount - 1),
                     field("points", &Task::points, "cm", -1000, 2000));
  }
};

struct BehaviourParams {
  Task task;
  // CPU seconds of one decide(). A sane script needs under a millisecond, so that a replay never
  // meets the limit; it only catches endless loops.
  double timeLimit = 0.25;
  bool reload = true;               // take over edited files; off on the robot
  std::uint32_t reloadFrames = 15;  // frames between two looks at the files
  // The fallback Command stands and swings the head; period, width and tilt of that.
  double scanPeriod = 3.0;
  Angle scanPan = Angle::deg(60.0);
  Angle scanTilt = Angle::deg(-20.0);

  static constexpr auto fields() {
    using P = BehaviourParams;
    return fieldList(field("task", &P::task), field("timeLimit", &P::timeLimit, "s", 0.01, 10),
                     field("reload", &P::reload),
                     field("reloadFrames", &P::reloadFrames, "", 1, 1000),
                     field("scanPeriod", &P::scanPeriod, "s", 0.5, 60),
                     field("scanPan", &P::scanPan, "rad", 0, 88),
                     field("scanTilt", &P::scanTilt, "rad", -75, 0));
  }
};

}  // namespace kelpie::behaviour
