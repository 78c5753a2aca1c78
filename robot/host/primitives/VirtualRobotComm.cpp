// SPDX-License-Identifier: Apache-2.0
#include "robot/host/primitives/VirtualRobotComm.h"

#include <OPENR/OSyslog.h>

#include "robot/host/primitives/DataVectors.h"
#include "robot/host/primitives/RobotPrimitives.h"

namespace kelpie::host {
namespace {

using openr::Message;
using openr::ObjectEntry;

VirtualRobotComm& comm(OObject& self) { return static_cast<VirtualRobotComm&>(self); }

template <Selector index>
void control(OObject& self, const Message& message) {
  comm(self).controlSubject(index, std::get<OControlMessage>(message));
}
template <Selector index>
void ready(OObject& self, const Message& message) {
  comm(self).readySubject(index, std::get<OReadyMessage>(message));
}
template <Selector index>
void connect(OObject& self, const Message& message) {
  comm(self).connectObserver(index, std::get<OConnectMessage>(message));
}
void notifyEffector(OObject& self, const Message& message) {
  comm(self).notifyEffector(std::get<ONotifyMessage>(message));
}
void notifySpeaker(OObject&, const Message&) {}

constexpr ObjectEntry kEntries[] = {
    {4, control<0>}, {5, control<1>},  {6, control<2>},  {7, ready<0>},        {8, ready<1>},
    {9, ready<2>},   {10, connect<0>}, {11, connect<1>}, {12, notifyEffector}, {13, notifySpeaker},
};

constexpr const char* kSubjectNames[] = {
    "OVirtualRobotComm.Sensor.OSensorFrameVectorData.S",
    "OVirtualRobotComm.FbkImageSensor.OFbkImageVectorData.S",
    "OVirtualRobotAudioComm.Mic.OSoundVectorData.S",
};
constexpr const char* kObserverNames[] = {
    "OVirtualRobotComm.Effector.OCommandVectorData.O",
    "OVirtualRobotAudioComm.Speaker.OSoundVectorData.O",
};

// So that of three regions one is always free to be filled.
constexpr std::size_t kBuffered = 1;

void complain(const char* what) { osyslog(osyslogERROR, "%s", what); }

template <std::size_t N>
RCRegion* freeRegion(const std::array<RCRegion*, N>& regions) {
  for (RCRegion* region : regions) {
    if (region->NumberOfReference() == 1) return region;
  }
  return nullptr;
}

}  // namespace

VirtualRobotComm::VirtualRobotComm(const RobotPrimitives& primitives, std::uint64_t sensorOrder,
                                   bool highPassRows)
    : primitives_(primitives) {
  for (RCRegion*& region : sensorRegions_) region = newSensorRegion(sensorOrder);
  for (RCRegion*& region : imageRegions_) region = newImageRegion(highPassRows);
}

VirtualRobotComm::~VirtualRobotComm() {
  for (RCRegion* region : sensorRegions_) region->RemoveReference();
  for (RCRegion* region : imageRegions_) region->RemoveReference();
  for (RCRegion* region : playing_) region->RemoveReference();
}

openr::ObjectStub VirtualRobotComm::stub() {
  return {this, "OVirtualRobotComm", kSubjects, kObservers, kEntries, std::size(kEntries)};
}

OStatus VirtualRobotComm::DoInit(const OSystemEvent&) {
  const openr::ObjectStub places = stub();
  for (Selector i = 0; i < kSubjects; ++i) {
    subjects_[i].SetReadyEntry({myOID_, places.ready(i)});
    subjects_[i].SetBufferSize(kBuffered);
    RegisterServiceEntry({myOID_, places.control(i)}, kSubjectNames[i]);
  }
  for (Selector i = 0; i < kObservers; ++i) {
    observers_[i].SetNotifyEntry({myOID_, places.notify(i)});
    RegisterServiceEntry({myOID_, places.connect(i)}, kObserverNames[i]);
  }
  return oSUCCESS;
}

OStatus VirtualRobotComm::DoStart(const OSystemEvent&) {
  assertIfFree();
  return oSUCCESS;
}

void VirtualRobotComm::sendSensors(std::uint32_t firstTick,
                                   const std::array<RawSensors, kTicksPerMessage>& frames) {
  RCRegion* region = freeRegion(sensorRegions_);
  if (region == nullptr) return complain("all sensor vectors are in use");
  fillSensors(*region, firstTick, frames);
  subjects_[kSensor].SetData(region);
  subjects_[kSensor].NotifyObservers();
}

void VirtualRobotComm::sendImage(const Image& image, std::uint32_t fieldCounter) {
  if (!primitives_.cameraOpen()) return;  // the robot sends images only after that
  RCRegion* region = freeRegion(imageRegions_);
  if (region == nullptr) return complain("all image vectors are in use");
  fillImage(*region, image, fieldCounter);
  subjects_[kImage].SetData(region);
  subjects_[kImage].NotifyObservers();
}

Status VirtualRobotComm::outputsDone(std::uint32_t count) {
  if (count > playing_.size()) {
    return Error{"the world has played " + std::to_string(count) + " command vectors, but got " +
                 std::to_string(playing_.size())};
  }
  for (; count > 0; --count) {
    playing_.front()->RemoveReference();
    playing_.pop_front();
  }
  assertIfFree();
  return Done{};
}

Expected<AgentReply> VirtualRobotComm::takeReply() {
  if (overflow_) {
    return Error{"more than " + std::to_string(reply_.vectors.kCapacity) +
                 " command vectors in one step"};
  }
  AgentReply reply = reply_;
  reply_.vectors.clear();
  reply.motorPower = primitives_.motorPower();
  reply.gains = primitives_.gains();
  reply.legGain = primitives_.legGain();
  return reply;
}

void VirtualRobotComm::controlSubject(Selector index, const OControlMessage& message) {
  subjects_[index].ControlHandler(message, oSUCCESS);
}

void VirtualRobotComm::readySubject(Selector index, const OReadyMessage& message) {
  subjects_[index].ReadyHandler(message);
}

void VirtualRobotComm::connectObserver(Selector index, const OConnectMessage& message) {
  observers_[index].ConnectHandler(message, oSUCCESS);
}

void VirtualRobotComm::notifyEffector(const ONotifyMessage& message) {
  effectorReady_ = false;
  for (int i = 0; i < message.NumberOfData(); ++i) {
    RCRegion* region = message.data[i].srcRCR;
    EffectorVector vector;
    const std::string complaint = readCommands(*region, primitives_, vector);
    if (!complaint.empty()) osyslog(osyslogERROR, "effector: %s", complaint.c_str());
    if (vector.ticks == 0) continue;
    region->AddReference();
    playing_.push_back(region);
    overflow_ = !reply_.vectors.push_back(vector) || overflow_;
  }
  assertIfFree();
}

void VirtualRobotComm::assertIfFree() {
  if (effectorReady_ || playing_.size() >= kVectorsAhead) return;
  effectorReady_ = true;
  observers_[kEffector].AssertReady();
}

}  // namespace kelpie::host
