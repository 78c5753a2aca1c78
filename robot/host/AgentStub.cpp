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
  agentOf(self).ReadyEffector(OReadyEvent(sbjEffector, content));
}

template <int index>
void connect(OObject& self, const openr::Message& message) {
  agentOf(self).observer[index]->ConnectHandler(std::get<OConnectMessage>(message), oSUCCESS);
}

template <int index, void (agent::Agent::*method)(const ONotifyEvent&)>
void notify(OObject& self, const openr::Message& message) {
  const auto& content = std::get<ONotifyMessage>(message);
  agentOf(self).observer[index]->NotifyHandler(content);
  (agentOf(self).*method)(ONotifyEvent(index, content));
}

constexpr openr::ObjectEntry kEntries[] = {
    {Control_Entry[sbjEffector], control},
    {Ready_Entry[sbjEffector], ready},
    {Connect_Entry[obsSensor], connect<obsSensor>},
    {Connect_Entry[obsFbkImageSensor], connect<obsFbkImageSensor>},
    {Notify_Entry[obsSensor], notify<obsSensor, &agent::Agent::NotifySensor>},
    {Notify_Entry[obsFbkImageSensor], notify<obsFbkImageSensor, &agent::Agent::NotifyImage>},
};

}  // namespace

openr::ObjectStub agentStub(agent::Agent& agent) {
  return {&agent, objectName, numOfSubject, numOfObserver, kEntries, std::size(kEntries)};
}

}  // namespace kelpie::host
