// SPDX-License-Identifier: Apache-2.0
// The receiving end of a service: tells its subjects when it can take the next data (openr.md 5.2).
// SetBufCtrlParam (subsampling and batching by the system) is not offered on the host. On the robot
// the class has 364 bytes; nobody may depend on that here.
#pragma once

#include <list>

#include "OPENR/ObjcommEvent.h"

using SubjectConstIterator = std::list<OSubjectInfo>::const_iterator;

class OObserver {
 public:
  OObserver();
  virtual ~OObserver();
  OObserver(const OObserver&) = delete;
  OObserver& operator=(const OObserver&) = delete;

  OStatus SetNotifyEntry(const OServiceEntry& entry);
  const ObserverID& GetID() const { return id_; }

  OStatus AssertReady() { return SendReadyAll(objcommCMD_ASSERT_READY); }
  OStatus AssertReady(const SubjectID& subject);
  OStatus AssertReady(const OSubjectInfo& subject);
  OStatus DeassertReady() { return SendReadyAll(objcommCMD_DEASSERT_READY); }
  OStatus DeassertReady(const SubjectID& subject);
  OStatus DeassertReady(const OSubjectInfo& subject);

  int NumberOfSubjects() const;
  SubjectConstIterator begin() const { return subjects_.begin(); }
  SubjectConstIterator end() const { return subjects_.end(); }

  // For the stub. The event is filled but for its index.
  OStatus ConnectHandler(const OConnectMessage& message, OStatus status = oSUCCESS);
  OStatus NotifyHandler(const ONotifyMessage& message, ONotifyEvent* event);

 private:
  OStatus SendReadyAll(ObjcommCommand command);  // the two above call it on the robot too
  OStatus say(ObjcommCommand command, const SubjectID& subject);

  ObserverID id_;
  std::list<OSubjectInfo> subjects_;
};
