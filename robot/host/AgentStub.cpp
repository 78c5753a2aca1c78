// SPDX-License-Identifier: Apache-2.0
// What the generated AgentStub.cc does on the robot: unpacks a message, lets the subject or
// observer handle its part, then calls the agent's method.
#include "robot/host/AgentStub.h"

#include "entry.h"

namespace kelpie::host {
namespace {

agent::Agent& agentOf(OObject& self) { return static_cast<agent::Agent&>(self); }

void control(OObject& self, const openr::Message& message) {
  agentOf(self).subject[sbjEffector]->ControlHandler(std::get<OControlMessage>(message), oSUCCESS);
}

void ready(OObject& self, const openr::Message& message) {
  const auto& content = std::get<OReadyMessage>(message);
  agentOf(self).subject[sbjEffector]->ReadyHandler(content);
  agentOf(self).ReadyEffector(OReadyEvent(sbjEffector, content.observerID, content.command));
}

template <int index>
void connect(OObject& self, const openr::Message& message) {
  agentOf(self).observer[index]->ConnectHandler(std::get<OConnectMessage>(message), oSUCCESS);
}

template <int index, void (agent::Agent::*method)(const ONotifyEvent&)>
void notify(OObject& self, const openr::Message& message) {
  const auto& content = std::get<ONotifyMessage>(message);
  ONotifyEvent event;
  agentOf(self).observer[index]->NotifyHandler(content, &event);
  event.SetIndex(index);
  (agentOf(self).*method)(event);
}

// A method of an Extra entry gets the message itself, by address.
void notifyPower(OObject& self, const openr::Message& message) {
  OPowerStatusMessage content = std::get<OPowerStatusMessage>(message);
  agentOf(self).NotifyPower(&content);
}

template <void (agent::Agent::*method)(void*)>
void answered(OObject& self, const openr::Message& message) {
  openr::AntReply content = std::get<openr::AntReply>(message);
  (agentOf(self).*method)(content.bytes.data());
}

constexpr openr::ObjectEntry kEntries[] = {
    {Entry_Control[sbjEffector], control},
    {Entry_Ready[sbjEffector], ready},
    {Entry_Connect[obsSensor], connect<obsSensor>},
    {Entry_Connect[obsFbkImageSensor], connect<obsFbkImageSensor>},
    {Entry_Notify[obsSensor], notify<obsSensor, &agent::Agent::NotifySensor>},
    {Entry_Notify[obsFbkImageSensor], notify<obsFbkImageSensor, &agent::Agent::NotifyImage>},
    {Extra_Entry[entryNotifyPower], notifyPower},
    {Extra_Entry[entryNotifyControl], answered<&agent::Agent::NotifyControl>},
    {Extra_Entry[entryNotifyTeam], answered<&agent::Agent::NotifyTeam>},
    {Extra_Entry[entryReadyTeam], answered<&agent::Agent::ReadyTeam>},
};

}  // namespace

openr::ObjectStub agentStub(agent::Agent& agent) {
  return {&agent, objectName, numOfSubject, numOfObserver, kEntries, std::size(kEntries)};
}

}  // namespace kelpie::host
