// SPDX-License-Identifier: Apache-2.0
// Kelpie as an OPEN-R object: opens the ERS-7's primitives, hands sensors and images to the loops
// in Kelpie's units, and sends the joint targets, always two command vectors ahead so that the
// joints never wait. Uses nothing but the documented API and does not know what stands behind it.
#pragma once

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include <array>

#include "def.h"
#include "robot/agent/AgentIo.h"
#include "robot/agent/AntRadio.h"
#include "robot/agent/loops/FaultLoops.h"
#include "robot/agent/loops/Loops.h"
#include "robot/body/Ers7.h"

namespace kelpie::agent {

class Agent : public OObject {
 public:
  // Without ports there is no radio: on the host packets come and go beside the object.
  explicit Agent(Loops& loops, const RadioPorts& ports = {}) : loops_(loops), radio_(ports) {}
  ~Agent() override;
  Agent(const Agent&) = delete;
  Agent& operator=(const Agent&) = delete;

  OSubject* subject[numOfSubject] = {};
  OObserver* observer[numOfObserver] = {};

  OStatus DoInit(const OSystemEvent& event) override;
  OStatus DoStart(const OSystemEvent& event) override;
  OStatus DoStop(const OSystemEvent& event) override;
  OStatus DoDestroy(const OSystemEvent& event) override;

  // Targets are sent when sensors arrive; that one was taken tells that gains may follow.
  void ReadyEffector(const OReadyEvent& event);
  void NotifySensor(const ONotifyEvent& event);
  void NotifyImage(const ONotifyEvent& event);
  // An OPowerStatusMessage: the state of the battery or of the pause switch has changed.
  void NotifyPower(void* message);
  // Answers of the network.
  void NotifyControl(void* message);
  void NotifyTeam(void* message);
  void ReadyTeam(void* message) { radio_.teamSent(message); }

 protected:
  virtual void beforeMotion() {}  // ahead of each message of the sensors
  virtual void frameDone() {}     // after each image

 private:
  // Two in flight and one to fill.
  static constexpr std::size_t kVectors = 3;

  // What was sent to a joint last.
  struct SentGain {
    bool on = false;
    bool refused = false;  // which is reported once
    body::JointGain gain{};
  };

  struct CommandVector {
    MemoryRegionID memory = 0;
    OCommandVectorData* data = nullptr;
    RCRegion* region = nullptr;
  };

  void openPrimitives();
  OStatus newVectors();
  OStatus limp();
  void obey(const MotorsOut& motors, body::LegGain legs);
  void tell(Rest rest);
  void setPower(bool on);
  void setGain(std::size_t joint, double strength, body::LegGain legs);
  void shutDown();
  std::uint32_t held() const;
  OStatus watchPower();
  void takePower(const OPowerStatus& status);
  OStatus readPose();
  void setCamera(const CameraSettings& wanted);
  bool readSensors(OSensorFrameVectorData& vector);
  TimeUs lastTick(OSensorFrameVectorData& vector);
  Loops& playing() { return crippled_ ? static_cast<Loops&>(crippledLoops_) : loops_; }
  void play();
  void sendHeld();
  void send(const std::array<JointFrame, kTicksPerMessage>& frames);
  std::size_t inFlight() const;

  Loops& loops_;
  FaultLoops crippledLoops_;  // in their place where a vital part does not open
  AntRadio radio_;
  PrimitiveIds ids_{};
  std::array<CommandVector, kVectors> vectors_;
  CommandPlaces places_{};  // the same in each of them
  SensorReader sensorReader_;
  MotionInput motionInput_;
  std::array<JointFrame, kTicksPerMessage> held_{};  // the last targets, at first the sensed pose
  Image image_;
  CameraSettings cameraSet_;  // asked for last; what is refused is not asked for again
  std::array<SentGain, kJointCount> gains_{};
  bool power_ = false;          // asked for
  bool motorPower_ = false;     // as the system said last
  bool sent_ = false;           // targets, since the power was asked for
  bool taken_ = false;          // so, and the effectors were ready for more
  bool shutDown_ = false;       // asked for
  TimeUs shutDownAgain_;        // if it was refused
  bool crippled_ = false;       // a joint or the camera does not open: it does not play
  bool lacks_ = false;          // something else does not
  Rest reported_ = Rest::none;  // in the system's log
  bool clockKnown_ = false;
  TimeUs tickZero_;  // system time of sensor tick 0
};

}  // namespace kelpie::agent
