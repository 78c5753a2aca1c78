// SPDX-License-Identifier: Apache-2.0
// Being carried. A robot that feels that it is lifted, or put down again, knows nothing of where it
// is. The end of a penalty: the robot has been put near a side line, on the half-way line, and
// looks across the field; on which side it does not know, as that goes by the ball. It believes in
// both places (so did the code of 2005: facts-2005 section 5.1) and does not search as one that was
// carried anywhere. Fails where the robot is put elsewhere: then the wide mode finds it, as ever.
#pragma once

#include "gps/pose/PoseParams.h"
#include "gps/pose/PoseState.h"
#include "robot/body/FieldDescription.h"
#include "robot/core/fields/Fields.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie::gps {

struct ReturnParams {
  bool use = true;
  double inside = 15.0;      // cm from the side line
  double positionSd = 25.0;  // cm, both ways: somebody may stand there already
  Angle headingSd = Angle::deg(15.0);

  template <int = 0>
  static constexpr auto fields() {
    using P = ReturnParams;
    return fieldList(field("use", &P::use), field("inside", &P::inside, "cm", -100, 100),
                     field("positionSd", &P::positionSd, "cm", 1, 500),
                     field("headingSd", &P::headingSd, "deg", 1, 180));
  }
};

// Once a frame; loses the pose in the ones in which somebody lifts the robot and puts it down.
void stepLift(bool lifted, const body::FieldDescription& field, const ModeParams& params,
              PoseState& state);

// Once a frame; changes the modes in the one in which a penalty has ended. They keep their tilt.
void stepReturn(const GameState& game, const body::FieldDescription& field,
                const ReturnParams& params, PoseState& state);

}  // namespace kelpie::gps
