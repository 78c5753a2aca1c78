// SPDX-License-Identifier: Apache-2.0
// The messages between subjects and observers, with the robot's sizes: 156 bytes (control), 144
// (connect, in OPENRMessages.h), 72 (ready) and 224 (notify) where pointers have 32 bits
// (openr-measured.md 2). Objects hand them on and do not look inside.
#pragma once

#include "OPENR/OPENRMessages.h"
#include "OPENR/ObjcommTypes.h"
#include "OPENR/RCRegion.h"

constexpr OMessageType omsgCONTROL = 12;
constexpr OMessageType omsgREADY_V22 = 261;
constexpr OMessageType omsgNOTIFY_V22 = 262;

// The system to a subject: an observer was connected to it, or left.
struct OControlMessage {
  OMessageType msgType = omsgCONTROL;
  ObjcommCommand command = objcommCMD_UNDEF;
  ObserverID observerID;
  std::size_t d_skip = 0;
  std::size_t d_min = 1;
  std::size_t d_max = 1;
  char subName[oserviceNAME_MAX + 1] = {};
};

// An observer to a subject: it can take data, or can no more.
struct OReadyMessage {
  OMessageType msgType = omsgREADY_V22;
  ObjcommCommand command = objcommCMD_UNDEF;
  ObserverID observerID;
  int numOfData = 0;
  RCRegion* rcRegion[MAX_NUM_DATA] = {};
};

struct TransferedData {
  RCRegion* srcRCR;
  MemoryRegionID memID;
  offset_t offset;
  std::size_t size;
};

// A subject to an observer. Holds one reference to each region until the observer's Notify method
// has returned.
struct ONotifyMessage {
  OMessageType msgType = omsgNOTIFY_V22;
  SubjectID subjectID;
  short numOfData = 0;
  short numOfNotify = 0;
  TransferedData data[MAX_NUM_DATA] = {};

  int NumberOfData() const { return numOfData; }
  int NumberOfNotify() const { return numOfNotify; }
  // One region more; refused when the message is full.
  OStatus Write(RCRegion* region);
  void Clear() { numOfData = numOfNotify = 0; }
};
