// SPDX-License-Identifier: Apache-2.0
#include <OPENR/OObserver.h>

#include <algorithm>

#include "robot/openr/System.h"

OObserver::OObserver() = default;
OObserver::~OObserver() = default;

int OObserver::NumberOfSubjects() const { return static_cast<int>(subjects_.size()); }

OStatus OObserver::SetNotifyEntry(const OServiceEntry& entry) {
  id_ = entry;
  return oSUCCESS;
}

OStatus OObserver::ConnectHandler(const OConnectMessage& message, OStatus status) {
  if (status != oSUCCESS) return status;
  const auto known = std::find(subjects_.begin(), subjects_.end(), message.entry);
  const bool connects = message.command == oconnectcmdCONNECT;
  if (connects == (known != subjects_.end())) return connects ? oALREADY_EXIST : oNOT_FOUND;
  if (connects) {
    subjects_.emplace_back(message.entry, objcommVERSION22);
  } else {
    subjects_.erase(known);
  }
  return oSUCCESS;
}

OStatus OObserver::NotifyHandler(const ONotifyMessage& message, ONotifyEvent* event) {
  const auto known = std::find(subjects_.begin(), subjects_.end(), message.subjectID);
  if (known == subjects_.end()) return oNOT_FOUND;
  event->SetSubjectInfo(*known);
  event->SetNumOfData(message.numOfData);
  event->SetNumOfNotify(message.numOfNotify);
  for (int i = 0; i < message.numOfData; ++i) event->SetData(i, message.data[i].srcRCR);
  return oSUCCESS;
}

// Not in the header: an object for the robot would want the name of `say`, which only the host has.
OStatus OObserver::AssertReady(const SubjectID& subject) {
  return say(objcommCMD_ASSERT_READY, subject);
}
OStatus OObserver::AssertReady(const OSubjectInfo& subject) {
  return say(objcommCMD_ASSERT_READY, subject);
}
OStatus OObserver::DeassertReady(const SubjectID& subject) {
  return say(objcommCMD_DEASSERT_READY, subject);
}
OStatus OObserver::DeassertReady(const OSubjectInfo& subject) {
  return say(objcommCMD_DEASSERT_READY, subject);
}

OStatus OObserver::SendReadyAll(ObjcommCommand command) {
  for (const OSubjectInfo& subject : subjects_) say(command, subject);
  return oSUCCESS;
}

OStatus OObserver::say(ObjcommCommand command, const SubjectID& subject) {
  if (std::find(subjects_.begin(), subjects_.end(), subject) == subjects_.end()) return oNOT_FOUND;
  OReadyMessage message;
  message.command = command;
  message.observerID = id_;
  kelpie::openr::currentSystem().post(subject, message);
  return oSUCCESS;
}
