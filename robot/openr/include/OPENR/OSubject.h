// SPDX-License-Identifier: Apache-2.0
// The sending end of a service. For each observer it keeps the ready state and a queue. What
// NotifyObservers does: observer asserted -> send now; waiting for its next assert -> keep, the
// oldest is overwritten on overflow; deasserted -> drop (openr.md 5.2). An observer that is new
// counts as waiting: what is notified before its first assert is kept (openr-measured.md 2). On the
// robot the class has 504 bytes; nobody may depend on that here.
#pragma once

#include <list>

#include "OPENR/OObserverInfo.h"
#include "OPENR/ObjcommEvent.h"

using ObserverConstIterator = std::list<OObserverInfo>::const_iterator;

class OSubject {
 public:
  OSubject();
  ~OSubject();
  OSubject(const OSubject&) = delete;
  OSubject& operator=(const OSubject&) = delete;

  OStatus SetReadyEntry(const OServiceEntry& entry);
  const SubjectID& GetID() const { return id_; }

  // Of the queue of each observer that comes from now on; 0: the default of 14.
  OStatus SetBufferSize(std::size_t count);
  std::size_t GetBufferSize() const { return bufferSize_; }
  OStatus SetNotifyUnitSize(std::size_t count);  // regions per transmission, 1 at first
  std::size_t GetNotifyUnitSize() const { return unit_; }

  OStatus SetData(RCRegion* region);
  OStatus SetData(const void* data, std::size_t size);
  OStatus SetData(const ObserverID& observer, RCRegion* region);
  OStatus SetData(const ObserverID& observer, const void* data, std::size_t size);
  OStatus SetData(const OObserverInfo& observer, RCRegion* region);
  OStatus NotifyObservers();
  OStatus NotifyObserver(const ObserverID& observer);
  OStatus NotifyObserver(const OObserverInfo& observer);
  std::size_t RemainBuffer() const;  // regions that wait, most over the observers
  std::size_t RemainBuffer(const ObserverID& observer) const;
  OStatus ClearBuffer();
  OStatus ClearBuffer(const ObserverID& observer);
  OStatus ClearBuffer(const OObserverInfo& observer);

  int NumberOfObservers() const;
  ObserverConstIterator begin() const { return observers_.begin(); }
  ObserverConstIterator end() const { return observers_.end(); }
  ObserverConstIterator FindObserver(const ObserverID& observer) const;

  // 1 asserted, 0 waiting, -1 deasserted.
  int ReadyStatus(const ObserverID& observer) const;
  int ReadyStatus(const OObserverInfo& observer) const;
  int IsAllReady() const;  // all asserted or deasserted, at least one asserted
  int IsAnyReady() const;
  int IsReady() const { return IsAnyReady(); }
  int IsReady(const ObserverID& observer) const { return ReadyStatus(observer) > 0 ? 1 : 0; }

  // For the stub.
  OStatus ControlHandler(const OControlMessage& message, OStatus status = oSUCCESS);
  OStatus ReadyHandler(const OReadyMessage& message);

 private:
  using Kept = OObserverInfo::Kept;
  Kept* find(const ObserverID& observer) const;
  OStatus add(const ObserverID& observer);
  OStatus remove(const ObserverID& observer);
  void notify(Kept& observer);
  void send(Kept& observer);

  SubjectID id_;
  std::size_t bufferSize_ = 0;
  std::size_t unit_ = 1;
  std::list<OObserverInfo> observers_;
};
