// SPDX-License-Identifier: Apache-2.0
// Status codes, identifiers and small structures that all of OPEN-R shares (openr.md 5.1, 5.5).
#pragma once

#include "Types.h"

using OStatus = longword;

constexpr OStatus oSUCCESS = 0;
constexpr OStatus oUNDEF = 1;
constexpr OStatus oFAIL = 2;
constexpr OStatus oNOT_SUPPORTED = 3;
constexpr OStatus oINVALID_ARG = 4;
constexpr OStatus oNO_MEMORY = 5;
constexpr OStatus oNOT_FOUND = 6;
constexpr OStatus oALREADY_EXIST = 7;
constexpr OStatus oOPEN_FAILURE = 8;
constexpr OStatus oCLOSE_FAILURE = 9;
constexpr OStatus oFULL_OF_QUEUE = 10;
constexpr OStatus oITEM_NOT_FOUND = 11;
constexpr OStatus oWRONG_MESSAGE = 12;
constexpr OStatus oSEND_FAIL = 13;
constexpr OStatus oCALL_FAIL = 15;
constexpr OStatus oNOT_INITIALIZED = 18;
constexpr OStatus oREFUSED = 19;
constexpr OStatus oSIZE_TOO_LARGE = 20;
constexpr OStatus oNOT_AVAILABLE = 21;
constexpr OStatus oOUT_OF_RANGE = 24;
constexpr OStatus oOVERFLOW = 25;
constexpr OStatus oUNDERFLOW = 26;
constexpr OStatus oFATAL = 28;
constexpr OStatus oBUSY = 33;

constexpr OStatus oAPI_STATUS_BASE = 4096;
constexpr OStatus oINVALID_PRIMITIVE_ID = oAPI_STATUS_BASE + 0;
constexpr OStatus oINVALID_DATA_VECTOR_ID = oAPI_STATUS_BASE + 1;
constexpr OStatus oINVALID_DATA_TYPE = oAPI_STATUS_BASE + 2;
constexpr OStatus oINVALID_DATA = oAPI_STATUS_BASE + 3;
constexpr OStatus oINVALID_REQUEST = oAPI_STATUS_BASE + 4;
constexpr OStatus oNO_SYNC_KEY = oAPI_STATUS_BASE + 10;
constexpr OStatus oINVALID_SYNC_KEY = oAPI_STATUS_BASE + 11;
constexpr OStatus oGAIN_DISABLED = oAPI_STATUS_BASE + 12;
constexpr OStatus oALERT_JOINT_UNCONTROLLABLE = 8192;

using OPrimitiveID = longword;
constexpr OPrimitiveID oprimitiveID_UNDEF = 0xffffffff;  // in gain calls: all opened joints

using OPower = bool;
constexpr OPower opowerON = true;
constexpr OPower opowerOFF = false;

// Where a message goes: an object and the number of the method in its entry table.
struct OServiceEntry {
  OID oid;
  Selector selector = UNDEF;

  bool operator==(const OServiceEntry& other) const {
    return oid == other.oid && selector == other.selector;
  }
};
static_assert(sizeof(OServiceEntry) == 8, "openr.md 3.4");

using OReason = longword;
constexpr OReason oreasonBOOT = 0;
constexpr OReason oreasonSHUTDOWN = 1;
constexpr OReason oreasonUNDEF = 0xffffffff;

// Why a life-cycle method is called. 12 bytes with the robot's 32-bit pointers.
class OSystemEvent {
 public:
  explicit OSystemEvent(OReason reason, void* param = nullptr, longword paramSize = 0)
      : reason_(reason), paramSize_(paramSize), param_(param) {}
  OReason Reason() const { return reason_; }
  void* Param() const { return param_; }
  longword ParamSize() const { return paramSize_; }

 private:
  OReason reason_;
  longword paramSize_;
  void* param_;
};
