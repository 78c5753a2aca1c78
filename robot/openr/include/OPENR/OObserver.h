// SPDX-License-Identifier: Apache-2.0
// The receiving end of a service: tells its subjects when it can take the next data (openr.md 5.2).
// SetBufCtrlParam (subsampling and batching by the system) is not offered on the host. On the robot
// the class has 364 bytes because of its std::list member.
#pragma once

#include <vector>

#include "OPENR/ObjcommEvent.h"

class OObserver {
 public:
  OObserver() = default;
  virtual ~OObserver() = default;
  OObserver(const OObserver&) = delete;
  OObserver& operator=(const OObserver&) = delete;

  void SetNotifyEntry(const OServiceEntry& entry) { id_ = entry; }
  ObserverID GetID() const { return id_; }

  OStatus AssertReady() { return sayToAll(true); }
  OStatus AssertReady(const SubjectID& subject) { return say(subject, true); }
  OStatus DeassertReady() { return sayToAll(false); }
  OStatus DeassertReady(const SubjectID& subject) { return say(subject, false); }

  int NumberOfSubjects() const { return static_cast<int>(subjects_.size()); }

  // For the stub.
  void ConnectHandler(const OConnectMessage& message, OStatus status);
  void NotifyHandler(const ONotifyMessage&) {}

 private:
  OStatus sayToAll(bool ready);
  OStatus say(const SubjectID& subject, bool ready);

  ObserverID id_;
  std::vector<SubjectID> subjects_;
};
