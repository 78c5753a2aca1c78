// SPDX-License-Identifier: Apache-2.0
// The robot's own OPEN-R object: gives sensors and images, takes command vectors, has a microphone
// that hears nothing and a speaker that says nothing. A command vector keeps its reference until
// the world has played it; two are taken ahead, and Ready tells that there is room again
// (openr.md 5.3).
#pragma once

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include <array>
#include <deque>

#include "robot/core/Expected.h"
#include "robot/core/types/Image.h"
#include "robot/host/world/WorldProtocol.h"
#include "robot/openr/ObjectStub.h"

namespace kelpie::host {

class RobotPrimitives;

class VirtualRobotComm : public OObject {
 public:
  static constexpr std::size_t kVectorsAhead = 2;

  VirtualRobotComm(const RobotPrimitives& primitives, std::uint64_t sensorOrder, bool highPassRows);
  ~VirtualRobotComm() override;
  openr::ObjectStub stub();

  OStatus DoInit(const OSystemEvent& event) override;
  OStatus DoStart(const OSystemEvent& event) override;

  void sendSensors(std::uint32_t firstTick, const std::array<RawSensors, kTicksPerMessage>& frames);
  void sendImage(const Image& image, std::uint32_t fieldCounter);
  // The oldest `count` vectors have been played: an error if there were fewer.
  Status outputsDone(std::uint32_t count);
  // What was commanded since the last call; an error if it is more than a reply holds.
  Expected<AgentReply> takeReply();
  std::size_t vectorsInFlight() const { return playing_.size(); }

  enum SubjectIndex : Selector { kSensor, kImage, kMicrophone, kSubjects };
  enum ObserverIndex : Selector { kEffector, kSpeaker, kObservers };

  void controlSubject(Selector index, const OControlMessage& message);
  void readySubject(Selector index, const OReadyMessage& message);
  void connectObserver(Selector index, const OConnectMessage& message);
  void notifyEffector(const ONotifyMessage& message);

 private:
  void assertIfFree();

  const RobotPrimitives& primitives_;
  std::array<OSubject, kSubjects> subjects_;
  std::array<OObserver, kObservers> observers_;
  std::array<RCRegion*, 3> sensorRegions_;  // one delivered, one buffered, one to fill
  std::array<RCRegion*, 3> imageRegions_;
  std::deque<RCRegion*> playing_;
  bool effectorReady_ = false;
  bool overflow_ = false;
  AgentReply reply_;
};

}  // namespace kelpie::host
