// SPDX-License-Identifier: Apache-2.0
// What can be tuned in the host of the behaviours, and the constants that a search may change.
#pragma once

#include <array>
#include <cstdint>

#include "behaviour/Constants.h"
#include "robot/core/Angle.h"
#include "robot/core/Enumerations.h"
#include "robot/core/fields/Fields.h"

namespace kelpie::behaviour {

// The part of `world` that is fixed before the match.
struct Task {
  PlayerKind player = PlayerKind::forward;
  RuleSet rules = RuleSet::kelpie;  // thesis: its rules alone, whatever stands in kicks, aiming,
                                    // search and intercept
  std::array<double, 10> points{};  // cm on the field: x, y of the challenge's five points
  bool grab = true;                 // the ball is grabbed where the decision tree says so
  bool run = false;                 // who attacks pushes the ball ahead and runs after it
  KickChoice kicks = KickChoice::map;
  Aiming aiming = Aiming::sight;
  BallSearch search = BallSearch::chain;
  bool dodge = true;      // with the ball, around who stands in the way
  bool intercept = true;  // a rolling ball is met where it will be
  Positioning positions = Positioning::tree;
  bool passing = false;         // the ball is played to mates, and positions value a pass
  bool distributedFind = true;  // a ball that the team lost is looked for by all of it
  bool birdOfPrey = true;       // who is far from home goes there on a curve round others
  bool scoreAware = false;      // the goalie goes forward when its team is far behind
  std::uint8_t skill = 0;       // of PlayerKind::skill: its number in main.SKILLS

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("player", &Task::player, "", 0, kPlayerKindCount - 1),
        field("rules", &Task::rules, "", 0, kRuleSetCount - 1),
        field("points", &Task::points, "cm", -1000, 2000), field("grab", &Task::grab),
        field("run", &Task::run), field("kicks", &Task::kicks, "", 0, kKickChoiceCount - 1),
        field("aiming", &Task::aiming, "", 0, kAimingCount - 1),
        field("search", &Task::search, "", 0, kBallSearchCount - 1), field("dodge", &Task::dodge),
        field("intercept", &Task::intercept),
        field("positions", &Task::positions, "", 0, kPositioningCount - 1),
        field("passing", &Task::passing), field("distributedFind", &Task::distributedFind),
        field("birdOfPrey", &Task::birdOfPrey), field("scoreAware", &Task::scoreAware),
        field("skill", &Task::skill, "", 0, 99));
  }
};

struct BehaviourParams {
  Task task;
  Constants constants;
  // CPU seconds of one decide(). A sane script needs under a millisecond, so that a replay never
  // meets the limit; it only catches endless loops.
  double timeLimit = 0.25;
  // Megabytes that Python may have of the system while decide() runs, with all that lives between
  // the frames; a script that wants more gets a MemoryError. The robot's programs may take 24 MB
  // (toolchain/budget.toml), of which 12 go to everything else; the behaviours of today need 4.5 on
  // a PC, whose pointers are twice as long.
  double heapLimit = 12.0;
  bool reload = true;               // take over edited files; off on the robot
  std::uint32_t reloadFrames = 30;  // frames between two looks at the files
  // The fallback Command stands and swings the head; period, width and tilt of that.
  double scanPeriod = 3.0;
  Angle scanPan = Angle::deg(60.0);
  Angle scanTilt = Angle::deg(-20.0);

  template <int = 0>
  static constexpr auto fields() {
    using P = BehaviourParams;
    return fieldList(field("task", &P::task), field("constants", &P::constants),
                     field("timeLimit", &P::timeLimit, "s", 0.01, 10),
                     field("heapLimit", &P::heapLimit, "MB", 1, 4000), field("reload", &P::reload),
                     field("reloadFrames", &P::reloadFrames, "", 1, 1000),
                     field("scanPeriod", &P::scanPeriod, "s", 0.5, 60),
                     field("scanPan", &P::scanPan, "rad", 0, 88),
                     field("scanTilt", &P::scanTilt, "rad", -75, 0));
  }
};

}  // namespace kelpie::behaviour
