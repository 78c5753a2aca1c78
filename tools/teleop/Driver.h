// SPDX-License-Identifier: Apache-2.0
// Makes the Command out of the keys so far: speeds and the head's direction by steps, motions that
// are asked for until they run. Keeps these and what it last asked; what the robot does meanwhile
// it learns from the view. A motion that does not start within three seconds is given up.
#pragma once

#include "robot/host/world/DriverProtocol.h"
#include "tools/teleop/Keys.h"

namespace kelpie::teleop {

class Driver {
 public:
  // A key that means nothing changes nothing.
  void press(char key);
  bool hasQuit() const { return quit_; }
  // What the body is asked for after this view. To be called once for each.
  Command next(const host::DriverView& view);

 private:
  void take(const KeyBinding& binding);
  void stop();
  void follow(const MotionStatus& motion);
  Command asked() const;

  int forward_ = 0;  // steps
  int left_ = 0;
  int turn_ = 0;
  int pan_ = 0;
  int tilt_ = 0;
  bool mouthOpen_ = false;
  bool holding_ = false;  // the head keeps the ball since a grab was asked for
  bool getUp_ = false;    // asked for; which motion that is the next view tells
  bool quit_ = false;
  MotionKind motion_ = MotionKind::none;  // wanted, and not yet running
  int views_ = 0;                         // in which it was asked for
};

}  // namespace kelpie::teleop
