// SPDX-License-Identifier: Apache-2.0
// What one skill asks for at its first step, at places all over the field, with a ball that lies
// still: the skill is begun anew at each. The robot knows its pose and the ball, its head is on the
// ball, and it sees ball and goals without noise; nobody else is on the field. What a skill does
// later, of what it remembers, is not shown.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "behaviour/Behaviour.h"
#include "robot/agent/AgentConfig.h"
#include "robot/core/Expected.h"

namespace kelpie::match {

struct SkillStep {
  Point2<Field> place;
  Point2<Field> way;  // cm/s on the field
  Angle turn;         // in a second, left positive
  MotionKind motion = MotionKind::none;
};

struct SkillQuestion {
  Point2<Field> ball;
  std::optional<Angle> heading;  // of the robot; none: it faces the ball
  double step = 20.0;            // cm between places
};

// The skill is that of config.behaviour.task. An error when the behaviours fail at a place.
Expected<std::vector<SkillStep>> skillField(const agent::AgentConfig& config,
                                            const SkillQuestion& question,
                                            behaviour::BehaviourState& behaviours);

}  // namespace kelpie::match
