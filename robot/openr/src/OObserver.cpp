// SPDX-License-Identifier: Apache-2.0
#include <OPENR/OObserver.h>

#include <algorithm>

#include "robot/openr/System.h"

void OObserver::ConnectHandler(const OConnectMessage& message, OStatus status) {
  const auto known = std::find(subjects_.begin(), subjects_.end(), message.subject);
  if (message.connect && status == oSUCCESS && known == subjects_.end()) {
    subjects_.push_back(message.subject);
  } else if (!message.connect && known != subjects_.end()) {
    subjects_.erase(known);
  }
}

OStatus OObserver::sayToAll(bool ready) {
  for (const SubjectID& subject : subjects_) say(subject, ready);
  return oSUCCESS;
}

OStatus OObserver::say(const SubjectID& subject, bool ready) {
  if (std::find(subjects_.begin(), subjects_.end(), subject) == subjects_.end()) return oNOT_FOUND;
  OReadyMessage message;
  message.sender = id_;
  message.isAssert = ready;
  kelpie::openr::currentSystem().post(subject, message);
  return oSUCCESS;
}
