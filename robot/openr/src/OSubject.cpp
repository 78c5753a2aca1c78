// SPDX-License-Identifier: Apache-2.0
#include <OPENR/OSubject.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <vector>

#include "robot/openr/System.h"

namespace {

// Transmissions that wait in the queue of an observer when nothing else was asked for: measured in
// the queue that the robot's library makes (openr-measured.md 2).
constexpr std::size_t kDefaultQueue = 14;

constexpr int kAsserted = 1;
constexpr int kWaiting = 0;  // for the first assert, or for the one after a notification
constexpr int kDeasserted = -1;

template <class Regions>
void release(Regions& regions) {
  for (RCRegion* region : regions) region->RemoveReference();
  regions.clear();
}

RCRegion* copied(const void* data, std::size_t size) {
  auto* region = new RCRegion(size);
  std::memcpy(region->Base(), data, size);
  return region;
}

}  // namespace

struct OObserverInfo::Kept {
  ObserverID id;
  std::size_t queueSize;
  int ready = kWaiting;
  std::vector<RCRegion*> set = {};      // by SetData, not yet notified
  std::deque<RCRegion*> buffered = {};  // notified, not yet sent

  void clear() {
    release(set);
    release(buffered);
  }
};

const ObserverID& OObserverInfo::GetObserverID() const { return kept_->id; }

OSubject::OSubject() = default;

OSubject::~OSubject() {
  for (const OObserverInfo& observer : observers_) {
    observer.kept_->clear();
    delete observer.kept_;
  }
}

OStatus OSubject::SetReadyEntry(const OServiceEntry& entry) {
  id_ = entry;
  return oSUCCESS;
}

OStatus OSubject::SetBufferSize(std::size_t count) {
  bufferSize_ = count;
  return oSUCCESS;
}

OStatus OSubject::SetNotifyUnitSize(std::size_t count) {
  if (count < 1 || count > MAX_NUM_DATA) return oINVALID_ARG;
  unit_ = count;
  return oSUCCESS;
}

OStatus OSubject::SetData(RCRegion* region) {
  for (const OObserverInfo& observer : observers_) SetData(observer, region);
  return oSUCCESS;
}

OStatus OSubject::SetData(const OObserverInfo& observer, RCRegion* region) {
  region->AddReference();
  observer.kept_->set.push_back(region);
  return oSUCCESS;
}

OStatus OSubject::SetData(const void* data, std::size_t size) {
  RCRegion* region = copied(data, size);
  const OStatus status = SetData(region);
  region->RemoveReference();
  return status;
}

OStatus OSubject::SetData(const ObserverID& observer, RCRegion* region) {
  const auto found = FindObserver(observer);
  return found == end() ? oNOT_FOUND : SetData(*found, region);
}

OStatus OSubject::SetData(const ObserverID& observer, const void* data, std::size_t size) {
  RCRegion* region = copied(data, size);
  const OStatus status = SetData(observer, region);
  region->RemoveReference();
  return status;
}

OStatus OSubject::NotifyObservers() {
  for (const OObserverInfo& observer : observers_) notify(*observer.kept_);
  return oSUCCESS;
}

OStatus OSubject::NotifyObserver(const ObserverID& observer) {
  const auto found = FindObserver(observer);
  return found == end() ? oNOT_FOUND : NotifyObserver(*found);
}

OStatus OSubject::NotifyObserver(const OObserverInfo& observer) {
  notify(*observer.kept_);
  return oSUCCESS;
}

void OSubject::notify(Kept& observer) {
  if (observer.ready == kDeasserted) return release(observer.set);
  observer.buffered.insert(observer.buffered.end(), observer.set.begin(), observer.set.end());
  observer.set.clear();
  send(observer);
  while (observer.buffered.size() > observer.queueSize * unit_) {
    observer.buffered.front()->RemoveReference();
    observer.buffered.pop_front();
  }
}

// The references of the regions go over to the message.
void OSubject::send(Kept& observer) {
  if (observer.ready != kAsserted || observer.buffered.size() < unit_) return;
  ONotifyMessage message;
  message.subjectID = id_;
  message.numOfNotify = 1;
  for (std::size_t i = 0; i < unit_; ++i) {
    message.Write(observer.buffered.front());
    observer.buffered.pop_front();
  }
  observer.ready = kWaiting;
  kelpie::openr::currentSystem().post(observer.id, message);
}

std::size_t OSubject::RemainBuffer() const {
  std::size_t max = 0;
  for (const OObserverInfo& observer : observers_)
    max = std::max(max, observer.kept_->buffered.size());
  return max;
}

std::size_t OSubject::RemainBuffer(const ObserverID& observer) const {
  const Kept* found = find(observer);
  return found == nullptr ? 0 : found->buffered.size();
}

OStatus OSubject::ClearBuffer() {
  for (const OObserverInfo& observer : observers_) observer.kept_->clear();
  return oSUCCESS;
}

OStatus OSubject::ClearBuffer(const ObserverID& observer) {
  Kept* found = find(observer);
  if (found == nullptr) return oNOT_FOUND;
  found->clear();
  return oSUCCESS;
}

OStatus OSubject::ClearBuffer(const OObserverInfo& observer) {
  observer.kept_->clear();
  return oSUCCESS;
}

ObserverConstIterator OSubject::FindObserver(const ObserverID& observer) const {
  return std::find_if(begin(), end(),
                      [&](const OObserverInfo& info) { return info.GetObserverID() == observer; });
}

int OSubject::NumberOfObservers() const { return static_cast<int>(observers_.size()); }

OSubject::Kept* OSubject::find(const ObserverID& observer) const {
  const auto found = FindObserver(observer);
  return found == end() ? nullptr : found->kept_;
}

int OSubject::ReadyStatus(const ObserverID& observer) const {
  const Kept* found = find(observer);
  return found == nullptr ? kDeasserted : found->ready;
}

int OSubject::ReadyStatus(const OObserverInfo& observer) const { return observer.kept_->ready; }

int OSubject::IsAllReady() const {
  const bool noneWaits = std::none_of(begin(), end(), [](const OObserverInfo& observer) {
    return observer.kept_->ready == kWaiting;
  });
  return noneWaits ? IsAnyReady() : 0;
}

int OSubject::IsAnyReady() const {
  const bool any = std::any_of(begin(), end(), [](const OObserverInfo& observer) {
    return observer.kept_->ready == kAsserted;
  });
  return any ? 1 : 0;
}

OStatus OSubject::ControlHandler(const OControlMessage& message, OStatus status) {
  if (status != oSUCCESS) return status;
  if (message.command == objcommCMD_ADDOBSERVER) return add(message.observerID);
  if (message.command == objcommCMD_REMOVEOBSERVER) return remove(message.observerID);
  return oWRONG_MESSAGE;
}

OStatus OSubject::add(const ObserverID& observer) {
  if (find(observer) != nullptr) return oALREADY_EXIST;
  const std::size_t queue = bufferSize_ == 0 ? kDefaultQueue : bufferSize_;
  observers_.push_back(OObserverInfo(new Kept{observer, queue}));
  return oSUCCESS;
}

OStatus OSubject::remove(const ObserverID& observer) {
  const auto found = FindObserver(observer);
  if (found == end()) return oNOT_FOUND;
  found->kept_->clear();
  delete found->kept_;
  observers_.erase(found);
  return oSUCCESS;
}

OStatus OSubject::ReadyHandler(const OReadyMessage& message) {
  Kept* observer = find(message.observerID);
  if (observer == nullptr) return oNOT_FOUND;
  const bool asserted = message.command == objcommCMD_ASSERT_READY;
  observer->ready = asserted ? kAsserted : kDeasserted;
  if (asserted) {
    send(*observer);
  } else {
    observer->clear();
  }
  return oSUCCESS;
}
