// SPDX-License-Identifier: Apache-2.0
// All that the OPEN-R object knows of the code above it: it hands over what the robot delivered, in
// Kelpie's units, and gets joint targets back.
#pragma once

#include "behaviour/RecentReports.h"
#include "robot/agent/CameraSettings.h"
#include "robot/agent/joints/Motors.h"
#include "robot/agent/joints/PowerReport.h"
#include "robot/core/types/ControlPacket.h"
#include "robot/core/types/Image.h"
#include "robot/core/types/Motion.h"
#include "robot/core/types/Radio.h"

namespace kelpie::agent {

class Loops {
 public:
  virtual ~Loops() = default;

  // Every 32 ms. Time is that of the last of the four ticks; command and rest are left for the
  // loops to fill in. The result is valid until the next call.
  virtual const MotionOutput& motion(const MotionInput& withoutCommand) = 0;

  // What the last motion wants of the motors' power and gains, and why the robot does not play.
  virtual const MotorsOut& motors() const = 0;

  // At the start, and when something of it has changed.
  virtual void power(const PowerReport& report) = 0;

  // What the camera is to be set to: another one when a robot has read its stick.
  virtual CameraSettings cameraSettings() const { return {}; }

  // Every image that arrives, with the camera's own number of it, which tells how many did not. The
  // image is valid during the call only.
  virtual void camera(const Image& image, TimeUs exposureMiddle, std::uint32_t number) = 0;

  // A packet of the game controller or of the radio, as it arrives.
  virtual void hear(const ControlPacket& packet, TimeUs now) = 0;
  virtual void hear(const RadioPacket& packet, TimeUs now) = 0;
  // The packet that the last frame made for the team, if it made one; each is given away once.
  virtual bool takePacket(RadioPacket& packet) = 0;
  // The next line that the behaviours tell people, valid until the next frame; null: no more.
  virtual const behaviour::ReportLine* takeLine() = 0;
};

}  // namespace kelpie::agent
