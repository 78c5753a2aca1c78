// SPDX-License-Identifier: Apache-2.0
// What a robot's behaviours tell its team of what they are about to do. Part of the Command, so
// that it is logged and replayed with it; gps puts it into the next TeamMessage.
#pragma once

#include <cstdint>

#include "robot/core/Enumerations.h"
#include "robot/core/fields/Fields.h"
#include "robot/core/types/Geometry.h"

namespace kelpie {

constexpr double kNoTime = 1000.0;  // s to the ball, of who does not go for it

struct TeamNote {
  Role role = Role::none;
  double timeToBall = kNoTime;  // s, bonuses counted (thesis 2006 section 4.4.1)
  Grabs grabs = Grabs::no;
  bool wants = false;       // whether `wanted` says anything
  Point2<Field> wanted;     // where it goes, or wants a pass
  std::uint8_t passTo = 0;  // number of the mate whom it plays the ball to; 0: nobody
  Possession possession = Possession::loose;  // as this robot sees it by itself

  template <int = 0>
  static constexpr auto fields() {
    using N = TeamNote;
    return fieldList(field("role", &N::role, "", 0, kRoleCount - 1),
                     field("timeToBall", &N::timeToBall, "s", 0, kNoTime),
                     field("grabs", &N::grabs, "", 0, kGrabsCount - 1), field("wants", &N::wants),
                     field("wanted", &N::wanted), field("passTo", &N::passTo, "", 0, 4),
                     field("possession", &N::possession, "", 0, kPossessionCount - 1));
  }
};

}  // namespace kelpie
