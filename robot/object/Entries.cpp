// SPDX-License-Identifier: Apache-2.0
// The robot's one object and a function for each of its entries: what the file of the SDK's stub
// generator has (robot/openr/stub/README.md), so that the gates see the whole object without an
// SDK. Never in the final link, which has the generated file in its place.
#include "robot/object/sdk/Agent.h"

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): as in the generated file
Agent Self;

namespace {

template <int index>
void connectTo(const OConnectMessage& message) {
  Self.observer[index]->ConnectHandler(message);
}

template <int index>
ONotifyEvent eventOf(const ONotifyMessage& message) {
  ONotifyEvent event;
  Self.observer[index]->NotifyHandler(message, &event);
  event.SetIndex(index);
  return event;
}

}  // namespace

extern "C" {

void kelpieEntryInit(const OSystemEvent& event) { Self.Init(event); }
void kelpieEntryStart(const OSystemEvent& event) { Self.Start(event); }
void kelpieEntryStop(const OSystemEvent& event) { Self.Stop(event); }
void kelpieEntryDestroy(const OSystemEvent& event) { Self.Destroy(event); }

void kelpieEntryControl(const OControlMessage& message) {
  Self.subject[sbjEffector]->ControlHandler(message);
}
void kelpieEntryReady(const OReadyMessage& message) {
  Self.subject[sbjEffector]->ReadyHandler(message);
  Self.ReadyEffector(OReadyEvent(sbjEffector, message.observerID, message.command));
}
void kelpieEntryConnectSensor(const OConnectMessage& message) { connectTo<obsSensor>(message); }
void kelpieEntryConnectImage(const OConnectMessage& message) {
  connectTo<obsFbkImageSensor>(message);
}
void kelpieEntrySensor(const ONotifyMessage& message) {
  Self.NotifySensor(eventOf<obsSensor>(message));
}
void kelpieEntryImage(const ONotifyMessage& message) {
  Self.NotifyImage(eventOf<obsFbkImageSensor>(message));
}

void kelpieEntryPower(void* message) { Self.NotifyPower(message); }
void kelpieEntryControlHeard(void* message) { Self.NotifyControl(message); }
void kelpieEntryTeamHeard(void* message) { Self.NotifyTeam(message); }
void kelpieEntryTeamSent(void* message) { Self.ReadyTeam(message); }
}
