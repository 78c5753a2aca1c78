// SPDX-License-Identifier: Apache-2.0
#include <OPENR/OSubject.h>

#include <algorithm>
#include <cstring>

#include "robot/openr/System.h"

namespace {

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

OSubject::~OSubject() { ClearBuffer(); }

void OSubject::SetNotifyUnitSize(std::size_t count) {
  unit_ = std::clamp<std::size_t>(count, 1, MAX_NUM_DATA);
}

OStatus OSubject::SetData(RCRegion* region) {
  for (OObserverInfo& observer : observers_) {
    region->AddReference();
    observer.set_.push_back(region);
  }
  return oSUCCESS;
}

OStatus OSubject::SetData(const void* data, std::size_t size) {
  RCRegion* region = copied(data, size);
  const OStatus status = SetData(region);
  region->RemoveReference();
  return status;
}

OStatus OSubject::SetData(const ObserverID& observer, RCRegion* region) {
  OObserverInfo* found = FindObserver(observer);
  if (found == nullptr) return oNOT_FOUND;
  region->AddReference();
  found->set_.push_back(region);
  return oSUCCESS;
}

OStatus OSubject::SetData(const ObserverID& observer, const void* data, std::size_t size) {
  RCRegion* region = copied(data, size);
  const OStatus status = SetData(observer, region);
  region->RemoveReference();
  return status;
}

OStatus OSubject::NotifyObservers() {
  for (OObserverInfo& observer : observers_) notify(observer);
  return oSUCCESS;
}

OStatus OSubject::NotifyObserver(const ObserverID& observer) {
  OObserverInfo* found = FindObserver(observer);
  if (found == nullptr) return oNOT_FOUND;
  notify(*found);
  return oSUCCESS;
}

void OSubject::notify(OObserverInfo& observer) {
  if (observer.ready_ == oreadyDEASSERT) return release(observer.set_);
  observer.buffered_.insert(observer.buffered_.end(), observer.set_.begin(), observer.set_.end());
  observer.set_.clear();
  send(observer);
  while (observer.buffered_.size() > bufferSize_ * unit_) {
    observer.buffered_.front()->RemoveReference();
    observer.buffered_.pop_front();
  }
}

// The references of the regions go over to the message.
void OSubject::send(OObserverInfo& observer) {
  if (observer.ready_ != oreadyASSERT || observer.buffered_.size() < unit_) return;
  ONotifyMessage message;
  message.sender = id_;
  for (std::size_t i = 0; i < unit_; ++i) {
    message.regions[message.count++] = observer.buffered_.front();
    observer.buffered_.pop_front();
  }
  observer.ready_ = oreadyWAITING;
  kelpie::openr::currentSystem().post(observer.id_, message);
}

std::size_t OSubject::RemainBuffer() const {
  std::size_t most = 0;
  for (const OObserverInfo& observer : observers_) {
    most = std::max(most, observer.buffered_.size());
  }
  return most;
}

void OSubject::ClearBuffer() {
  for (OObserverInfo& observer : observers_) {
    release(observer.set_);
    release(observer.buffered_);
  }
}

OObserverInfo* OSubject::FindObserver(const ObserverID& observer) {
  const auto found =
      std::find_if(begin(), end(), [&](const OObserverInfo& info) { return info.id_ == observer; });
  return found == end() ? nullptr : &*found;
}

int OSubject::ReadyStatus(const ObserverID& observer) {
  const OObserverInfo* found = FindObserver(observer);
  return found == nullptr ? oreadyDEASSERT : found->ready_;
}

int OSubject::IsAllReady() const {
  const bool noneWaits =
      std::none_of(observers_.begin(), observers_.end(),
                   [](const OObserverInfo& info) { return info.ready_ == oreadyWAITING; });
  return noneWaits ? IsAnyReady() : 0;
}

int OSubject::IsAnyReady() const {
  return std::any_of(observers_.begin(), observers_.end(),
                     [](const OObserverInfo& info) { return info.ready_ == oreadyASSERT; })
             ? 1
             : 0;
}

void OSubject::ControlHandler(const OControlMessage& message, OStatus status) {
  OObserverInfo* known = FindObserver(message.observer);
  if (status == oSUCCESS && message.add && known == nullptr) {
    observers_.emplace_back(message.observer);
  } else if (!message.add && known != nullptr) {
    release(known->set_);
    release(known->buffered_);
    observers_.erase(begin() + (known - observers_.data()));
  }
}

void OSubject::ReadyHandler(const OReadyMessage& message) {
  OObserverInfo* observer = FindObserver(message.sender);
  if (observer == nullptr) return;
  observer->ready_ = message.isAssert ? oreadyASSERT : oreadyDEASSERT;
  if (message.isAssert) return send(*observer);
  release(observer->set_);
  release(observer->buffered_);
}
