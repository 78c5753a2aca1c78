// SPDX-License-Identifier: Apache-2.0
// The two loops behind the OPEN-R object: assembles MotionInput and FrameInput from what arrives
// (joints at the exposure, odometry since the last image, last Command) and hands results on. Keeps
// only what the next input needs, so a log of the inputs replays to the same outputs.
#pragma once

#include <memory>
#include <string>

#include "robot/agent/joints/Causes.h"
#include "robot/agent/joints/JointTrack.h"
#include "robot/agent/joints/JointWatch.h"
#include "robot/agent/joints/Motors.h"
#include "robot/agent/joints/OdometryTrack.h"
#include "robot/agent/log/LogSink.h"
#include "robot/agent/loops/FrameLoop.h"
#include "robot/agent/loops/Loops.h"
#include "robot/agent/loops/MotionLoop.h"
#include "robot/agent/loops/Watchdog.h"
#include "robot/net/GameListener.h"
#include "robot/net/TeamRadio.h"

namespace kelpie::agent {

class AgentLoops : public Loops {
 public:
  // `beside`: another robot's of this process, if there is one (BehaviourState).
  AgentLoops(const AgentConfig& config, const std::string& scripts, LogSink& log,
             const AgentLoops* beside = nullptr);

  const MotionOutput& motion(const MotionInput& withoutCommand) override;
  const MotorsOut& motors() const override { return motors_; }
  void power(const PowerReport& report) override { power_ = report; }
  CameraSettings cameraSettings() const override { return cameraSettings_; }
  void camera(const Image& image, TimeUs exposureMiddle, std::uint32_t number) override;
  // The same where nothing is rendered: the FrameInput has no image, and vision is not asked.
  void look(Sight& sight, TimeUs exposureMiddle, std::uint32_t number);

  void setDrive(const Drive& drive) { drive_ = drive; }
  void hear(const ControlPacket& packet, TimeUs now) override;
  void hear(const RadioPacket& packet, TimeUs now) override;
  bool takePacket(RadioPacket& packet) override;
  const behaviour::ReportLine* takeLine() override {
    return frameLoop_.reports().next(linesTaken_);
  }
  const std::string& scriptError() const { return frameLoop_.scriptError(); }

 private:
  Cause causeNow(const MotionInput& in);
  void decideMotors(const MotionInput& in);
  void feelButtons(TimeUs when, const SensorFrame& sensed);
  Command forTheBody() const;
  void expose(TimeUs exposureMiddle, std::uint32_t number);
  void take(const FrameOutput& frame);

  FrameLoop frameLoop_;
  MotionLoop motionLoop_;
  LogSink& log_;
  CameraTilt startingTilt_;
  FocalScale startingFocal_;
  ImageLag startingLag_;
  StageObserver silent_;
  CameraSettings cameraSettings_;
  net::ListenerParams listens_;
  net::ListenerState game_;
  Drive drive_;
  PowerReport power_;
  CausesState causes_;
  WatchdogState watchdog_;
  bool imageCame_ = false;  // since the last motion message
  JointWatchState jointWatch_;
  MotorsState motorsState_;
  MotorsOut motors_;
  MotionInput motionInput_;
  const MotionOutput* motionOutput_ = nullptr;
  FrameInput input_;  // a member because of its size
  const FrameOutput* frame_ = nullptr;
  std::uint32_t frameCount_ = 0;
  std::uint32_t cameraNumber_ = 0;  // of the last image
  JointTrack joints_;
  OdometryTrack odometry_;
  net::RadioState radio_;
  std::uint16_t sent_ = 0;        // number of the message that was given away last
  std::uint32_t linesTaken_ = 0;  // of the behaviours
};

}  // namespace kelpie::agent
