// SPDX-License-Identifier: Apache-2.0
// Status codes, identifiers and small structures that all of OPEN-R shares (openr.md 5.1, 5.5;
// openr-measured.md 2).
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

constexpr OStatus OStatusAPISpecificBase = 4096;
constexpr OStatus oINVALID_PRIMITIVE_ID = OStatusAPISpecificBase + 0;
constexpr OStatus oINVALID_DATA_VECTOR_ID = OStatusAPISpecificBase + 1;
constexpr OStatus oINVALID_DATA_TYPE = OStatusAPISpecificBase + 2;
constexpr OStatus oINVALID_DATA = OStatusAPISpecificBase + 3;
constexpr OStatus oINVALID_REQUEST = OStatusAPISpecificBase + 4;
constexpr OStatus oNO_SYNC_KEY = OStatusAPISpecificBase + 10;
constexpr OStatus oINVALID_SYNC_KEY = OStatusAPISpecificBase + 11;
constexpr OStatus oGAIN_DISABLED = OStatusAPISpecificBase + 12;
constexpr OStatus oALERT_JOINT_UNCONTROLLABLE = 8192;

using OPrimitiveID = longword;
constexpr OPrimitiveID oprimitiveID_UNDEF = 0xffffffff;  // in gain calls: all opened joints

// Where a message goes: an object and the number of the method in its entry table. Not an
// aggregate, and not to be copied byte by byte (openr-measured.md 2).
class OServiceEntry {
 public:
  OServiceEntry() = default;
  OServiceEntry(const OID& object, Selector method) : oid(object), selector(method) {}
  // NOLINTNEXTLINE(modernize-use-equals-default): the robot's is no trivial copy
  OServiceEntry(const OServiceEntry& other) : oid(other.oid), selector(other.selector) {}
  OServiceEntry& operator=(const OServiceEntry&) = default;
  ~OServiceEntry() = default;

  void Set(const OID& object, Selector method) { *this = OServiceEntry(object, method); }
  bool IsValid() const { return oid.IsValid() && selector != UNDEF; }

  friend bool operator==(const OServiceEntry& one, const OServiceEntry& other) {
    return one.oid == other.oid && one.selector == other.selector;
  }
  friend bool operator!=(const OServiceEntry& one, const OServiceEntry& other) {
    return !(one == other);
  }
  friend bool operator<(const OServiceEntry& one, const OServiceEntry& other) {
    return one.oid == other.oid ? one.selector < other.selector : one.oid < other.oid;
  }

  OID oid;
  Selector selector = UNDEF;
};

using OReason = longword;
constexpr OReason oreasonBOOT = 0;
constexpr OReason oreasonSHUTDOWN = 1;
constexpr OReason oreasonUNDEF = 0xffffffff;

constexpr std::size_t oserviceNAME_MAX = 127;  // letters of a service's name
