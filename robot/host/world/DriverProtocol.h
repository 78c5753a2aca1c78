// SPDX-License-Identifier: Apache-2.0
// What an agent and the program of a person who drives it say to each other, in the messages of
// WorldProtocol.h: after each image the agent tells what it sees and feels, and gets back what its
// body shall do from the next image on. Nothing of the simulated world is in it: a robot could send
// and hear the same by wireless network.
#pragma once

#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Percepts.h"

namespace kelpie::host {

// Agent to driver.
struct DriverView {
  TimeUs time;  // of the image, middle of its exposure
  MotionStatus motion;
  Command command;   // that the body was given last
  BallPercept ball;  // in this image
  Image image;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("time", &DriverView::time, "us"), field("motion", &DriverView::motion),
                     field("command", &DriverView::command), field("ball", &DriverView::ball),
                     field("image", &DriverView::image));
  }
};

}  // namespace kelpie::host
