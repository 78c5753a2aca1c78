// SPDX-License-Identifier: Apache-2.0
// The sending end of a service. For each observer it keeps the ready state and a buffer. What
// NotifyObservers does: observer asserted -> send now; waiting for its next assert -> keep, the
// oldest is overwritten on overflow; deasserted -> drop (openr.md 5.2). On the robot the class has
// 504 bytes because of its std::list members; nobody may depend on that here.
#pragma once

#include <deque>
#include <vector>

#include "OPENR/ObjcommEvent.h"

constexpr int oreadyASSERT = 1;
constexpr int oreadyWAITING = 0;  // a notification was sent, the next assert is awaited
constexpr int oreadyDEASSERT = -1;

class OObserverInfo {
 public:
  explicit OObserverInfo(const ObserverID& id) : id_(id) {}
  ObserverID GetID() const { return id_; }
  int ReadyStatus() const { return ready_; }

 private:
  friend class OSubject;
  ObserverID id_;
  int ready_ = oreadyDEASSERT;
  std::vector<RCRegion*> set_;      // by SetData, not yet notified
  std::deque<RCRegion*> buffered_;  // notified, not yet sent
};

class OSubject {
 public:
  using Iterator = std::vector<OObserverInfo>::iterator;

  OSubject() = default;
  ~OSubject();
  OSubject(const OSubject&) = delete;
  OSubject& operator=(const OSubject&) = delete;

  void SetReadyEntry(const OServiceEntry& entry) { id_ = entry; }
  SubjectID GetID() const { return id_; }

  void SetBufferSize(std::size_t count) { bufferSize_ = count; }  // in transmissions
  std::size_t GetBufferSize() const { return bufferSize_; }
  void SetNotifyUnitSize(std::size_t count);  // regions per transmission, 1 at first

  OStatus SetData(RCRegion* region);
  OStatus SetData(const void* data, std::size_t size);
  OStatus SetData(const ObserverID& observer, RCRegion* region);
  OStatus SetData(const ObserverID& observer, const void* data, std::size_t size);
  OStatus NotifyObservers();
  OStatus NotifyObserver(const ObserverID& observer);
  std::size_t RemainBuffer() const;  // regions that wait, most over the observers
  void ClearBuffer();

  int NumberOfObservers() const { return static_cast<int>(observers_.size()); }
  Iterator begin() { return observers_.begin(); }
  Iterator end() { return observers_.end(); }
  OObserverInfo* FindObserver(const ObserverID& observer);
  int ReadyStatus(const ObserverID& observer);
  int IsAllReady() const;  // all asserted or deasserted, at least one asserted
  int IsAnyReady() const;
  int IsReady() const { return IsAllReady(); }

  // For the stub.
  void ControlHandler(const OControlMessage& message, OStatus status);
  void ReadyHandler(const OReadyMessage& message);

 private:
  void notify(OObserverInfo& observer);
  void send(OObserverInfo& observer);

  SubjectID id_;
  std::size_t bufferSize_ = 1;
  std::size_t unit_ = 1;
  std::vector<OObserverInfo> observers_;
};
