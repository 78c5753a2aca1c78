// SPDX-License-Identifier: Apache-2.0
// What the service methods of an object receive (openr.md 5.2).
#pragma once

#include "OPENR/ObjcommTypes.h"
#include "OPENR/RCRegion.h"

class OControlEvent {
 public:
  OControlEvent(int index, const OControlMessage& message) : index_(index), message_(message) {}
  int SbjIndex() const { return index_; }
  ObserverID SenderID() const { return message_.observer; }
  const char* SubName() const { return message_.name; }
  bool IsAddObserver() const { return message_.add; }
  bool IsRemoveObserver() const { return !message_.add; }

 private:
  int index_;
  const OControlMessage& message_;
};

class OConnectEvent {
 public:
  OConnectEvent(int index, const OConnectMessage& message) : index_(index), message_(message) {}
  int ObsIndex() const { return index_; }
  SubjectID SenderID() const { return message_.subject; }
  const char* SubName() const { return message_.name; }
  bool IsConnect() const { return message_.connect; }
  bool IsDisconnect() const { return !message_.connect; }

 private:
  int index_;
  const OConnectMessage& message_;
};

class OReadyEvent {
 public:
  OReadyEvent(int index, const OReadyMessage& message) : index_(index), message_(message) {}
  int SbjIndex() const { return index_; }
  ObserverID SenderID() const { return message_.sender; }
  bool IsAssert() const { return message_.isAssert; }
  bool IsDeassert() const { return !message_.isAssert; }

 private:
  int index_;
  const OReadyMessage& message_;
};

class ONotifyEvent {
 public:
  ONotifyEvent(int index, const ONotifyMessage& message) : index_(index), message_(message) {}
  int ObsIndex() const { return index_; }
  int NumOfData() const { return static_cast<int>(message_.count); }
  int NumOfNotify() const { return 1; }  // batching of notifications is not offered here
  void* Data(int i) const { return message_.regions[i]->Base(); }
  // Add a reference to keep the data beyond the method.
  RCRegion* RCData(int i) const { return message_.regions[i]; }
  SubjectID SenderID() const { return message_.sender; }

 private:
  int index_;
  const ONotifyMessage& message_;
};
