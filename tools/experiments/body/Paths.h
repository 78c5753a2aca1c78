// SPDX-License-Identifier: Apache-2.0
// What a body really walked, and what its odometry estimated.
#pragma once

#include "tools/sim/bodies/WalkingBody.h"

namespace kelpie::experiments {

// In the robot frame, summed over its turns.
struct Displacement {
  double forward = 0.0;  // cm
  double left = 0.0;     // cm
  double turn = 0.0;     // rad
};

struct Paths {
  Displacement walked;
  Displacement reported;
};

// Adds so many messages of 32 ms with that request.
inline void walkOn(sim::WalkingBody& body, const WalkRequest& request, int messages, Paths& ways) {
  Command command;
  command.walk = request;
  for (int i = 0; i < messages; ++i) {
    const Pose2 last = body.pose();
    const Odometry odometry = body.step(command).odometry;
    const Point2<Robot> moved = robotFromField(last, body.pose().position);
    Displacement& reported = ways.reported;
    reported = {reported.forward + odometry.forward, reported.left + odometry.left,
                reported.turn + odometry.turn.rad()};
    Displacement& walked = ways.walked;
    walked = {walked.forward + moved.y, walked.left - moved.x,
              walked.turn + (body.pose().heading - last.heading).rad()};
  }
}

}  // namespace kelpie::experiments
