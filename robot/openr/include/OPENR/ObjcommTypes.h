// SPDX-License-Identifier: Apache-2.0
// The messages between subjects and observers. Their inside is the system's affair: on the robot
// they have 156 (control), 72 (ready), 144 (connect) and 224 bytes (notify) with 32-bit pointers.
#pragma once

#include "OPENR/OPENR.h"

class RCRegion;

using SubjectID = OServiceEntry;   // the Ready entry of a subject
using ObserverID = OServiceEntry;  // the Notify entry of an observer

constexpr std::size_t MAX_NUM_DATA = 13;  // most regions in one notification
constexpr std::size_t MAX_SERVICE_NAME = 128;

// The system to a subject: an observer was connected to it, or left.
struct OControlMessage {
  ObserverID observer;
  bool add = true;
  char name[MAX_SERVICE_NAME] = {};
};

// The system to an observer: it was connected to a subject, or taken off it.
struct OConnectMessage {
  SubjectID subject;
  bool connect = true;
  char name[MAX_SERVICE_NAME] = {};
};

struct OReadyMessage {
  ObserverID sender;
  bool isAssert = true;
};

// Holds one reference to each region until the observer's Notify method has returned.
struct ONotifyMessage {
  SubjectID sender;
  longword count = 0;
  RCRegion* regions[MAX_NUM_DATA] = {};
};
