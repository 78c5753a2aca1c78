// SPDX-License-Identifier: Apache-2.0
// Odometry as a function of time. The motion loop reports what was walked in steps of 32 ms, images
// are exposed in between: the total at any time is interpolated, and extrapolated at the last rate
// for at most one step, because an image may be newer than the last sensor message. Components are
// summed in the robot frame; over one camera frame (at most 0.1 rad) the error is below 0.1 cm.
#pragma once

#include "robot/core/Motion.h"

namespace kelpie::agent {

class OdometryTrack {
 public:
  // A step that ended at `end` and lasted one message.
  void add(TimeUs end, const Odometry& step) {
    forward_ += step.forward;
    left_ += step.left;
    turn_ += step.turn.rad();
    last_ = step;
    end_ = end;
  }

  // What was walked between the previous call and `time`.
  Odometry until(TimeUs time) {
    const double message = kTickSeconds * kTicksPerMessage;
    const double steps = maths::clamp((time - end_).seconds() / message, -1.0, 1.0);
    const Odometry walked{forward_ + steps * last_.forward - takenForward_,
                          left_ + steps * last_.left - takenLeft_,
                          Angle::rad(turn_ + steps * last_.turn.rad() - takenTurn_)};
    takenForward_ += walked.forward;
    takenLeft_ += walked.left;
    takenTurn_ += walked.turn.rad();
    return walked;
  }

 private:
  double forward_ = 0.0;
  double left_ = 0.0;
  double turn_ = 0.0;
  double takenForward_ = 0.0;
  double takenLeft_ = 0.0;
  double takenTurn_ = 0.0;
  Odometry last_;
  TimeUs end_;
};

}  // namespace kelpie::agent
