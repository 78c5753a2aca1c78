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
#include "robot/agent/Loops.h"
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

  void ReadyEffector(const OReadyEvent&) {}  // targets are sent when sensors arrive
  void NotifySensor(const ONotifyEvent& event);
  void NotifyImage(const ONotifyEvent& event);
  // An OPowerStatusMessage: the state of the battery or of the pause switch has changed.
  void NotifyPower(void* message);
  // Answers of the network.
  void NotifyControl(void* message);
  void NotifyTeam(void* message);
  void ReadyTeam(void* message) { radio_.teamSent(message); }

 protected:
  virtual void frameDone() {}  // after each image

 private:
  // Two in flight and one to fill.
  static constexpr std::size_t kVectors = 3;

  struct CommandVector {
    MemoryRegionID memory = 0;
    OCommandVectorData* data = nullptr;
    RCRegion* region = nullptr;
  };

  OStatus openPrimitives();
  OStatus newVectors();
  OStatus enableGains();
  OStatus setGains(body::LegGain legs);
  void changeGains(body::LegGain legs);
  OStatus watchPower();
  void takePower(const OPowerStatus& status);
  OStatus readPose();
  void setCamera();
  bool readSensors(OSensorFrameVectorData& vector);
  TimeUs lastTick(OSensorFrameVectorData& vector);
  void sendHeld();
  void send(const std::array<JointFrame, kTicksPerMessage>& frames);
  std::size_t inFlight() const;

  Loops& loops_;
  AntRadio radio_;
  PrimitiveIds ids_{};
  std::array<CommandVector, kVectors> vectors_;
  SensorReader sensorReader_;
  MotionInput motionInput_;
  std::array<JointFrame, kTicksPerMessage> held_{};  // the last targets, at first the sensed pose
  Image image_;
  body::LegGain legGain_;    // what the legs were told last
  bool motorPower_ = false;  // as the system said last
  bool clockKnown_ = false;
  TimeUs tickZero_;  // system time of sensor tick 0
};

}  // namespace kelpie::agent
