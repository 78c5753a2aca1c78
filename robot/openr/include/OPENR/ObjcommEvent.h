// SPDX-License-Identifier: Apache-2.0
// What the service methods of an object receive (openr.md 5.2): 20 (control), 12 (connect), 16
// (ready) and 76 bytes (notify) with the robot's 32-bit pointers (openr-measured.md 2).
#pragma once

#include "OPENR/OSubjectInfo.h"
#include "OPENR/ObjcommMessages.h"

class OControlEvent {
 public:
  OControlEvent(int index, const ObserverID& observer, char* name, ObjcommCommand command)
      : index_(index), observer_(observer), name_(name), command_(command) {}
  int SbjIndex() const { return index_; }
  const ObserverID& SenderID() const { return observer_; }
  const char* SubName() const { return name_; }
  bool IsAddObserver() const { return command_ == objcommCMD_ADDOBSERVER; }
  bool IsRemoveObserver() const { return command_ == objcommCMD_REMOVEOBSERVER; }

 private:
  int index_;
  ObserverID observer_;
  char* name_;
  ObjcommCommand command_;
};

// Does not tell whose subject it is.
class OConnectEvent {
 public:
  OConnectEvent(int index, char* name, OConnectCmd command)
      : index_(index), name_(name), command_(command) {}
  int ObsIndex() const { return index_; }
  const char* SubName() const { return name_; }
  bool IsConnect() const { return command_ == oconnectcmdCONNECT; }
  bool IsDisconnect() const { return command_ == oconnectcmdDISCONNECT; }

 private:
  int index_;
  char* name_;
  OConnectCmd command_;
};

class OReadyEvent {
 public:
  OReadyEvent(int index, const ObserverID& observer, ObjcommCommand command)
      : index_(index), observer_(observer), command_(command) {}
  int SbjIndex() const { return index_; }
  const ObserverID& SenderID() const { return observer_; }
  bool IsAssert() const { return command_ == objcommCMD_ASSERT_READY; }
  bool IsDeassert() const { return command_ == objcommCMD_DEASSERT_READY; }

 private:
  int index_;
  ObserverID observer_;
  ObjcommCommand command_;
};

// Empty at first; OObserver::NotifyHandler fills it.
class ONotifyEvent {
 public:
  void SetIndex(int index) { index_ = index; }
  void SetSubjectInfo(const OSubjectInfo& subject) { subject_ = subject; }
  void SetNumOfData(int count) { dataCount_ = count; }
  void SetNumOfNotify(int count) { notifyCount_ = count; }
  void SetData(int i, RCRegion* region) { regions_[i] = region; }

  int ObsIndex() const { return index_; }
  const OSubjectInfo& SenderID() const { return subject_; }
  int NumOfData() const { return dataCount_; }
  int NumOfNotify() const { return notifyCount_; }
  const void* Data(int i) const { return regions_[i]->Base(); }
  // Add a reference to keep the data beyond the method.
  RCRegion* RCData(int i) const { return regions_[i]; }

 private:
  int index_ = 0;
  OSubjectInfo subject_;
  int dataCount_ = 0;
  int notifyCount_ = 0;
  RCRegion* regions_[MAX_NUM_DATA] = {};
};
