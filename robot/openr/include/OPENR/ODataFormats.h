// SPDX-License-Identifier: Apache-2.0
// Layout of everything that travels between an object and the robot's hardware (openr.md 5.3). A
// vector is ODataVectorInfo, then one info per primitive, then the data blocks that the infos point
// to; the first info is a part of the struct. Offsets and sizes are std::size_t, as on the robot,
// so that a vector with them is longer on a PC: the robot's sizes (openr.md 3.4, openr-measured.md
// 2) are asserted where pointers have 32 bits. The methods of a vector are not const there.
#pragma once

#include "OPENR/OCdtChannel.h"
#include "OPENR/OPENR.h"
#include "OPENR/OUnits.h"

using ODataType = longword;
constexpr ODataType odataFBK_YCrCb = 19;
constexpr ODataType odataFBK_CDT = 20;
constexpr ODataType odataFBK_YCrCb_HPF = 24;
constexpr ODataType odataJOINT_COMMAND2 = 259;
constexpr ODataType odataLED_COMMAND2 = 260;
constexpr ODataType odataJOINT_COMMAND3 = 261;
constexpr ODataType odataJOINT_COMMAND4 = 262;
constexpr ODataType odataLED_COMMAND3 = 263;
constexpr ODataType odataCOMMAND_VECTOR = 1024;
constexpr ODataType odataSENSOR_FRAME_VECTOR = 1025;
constexpr ODataType odataSOUND_VECTOR = 1026;
constexpr ODataType odataFBKIMAGE_VECTOR = 1027;
constexpr ODataType odataCDT_VECTOR = 1028;

constexpr std::size_t ocommandMAX_FRAMES = 16;  // 128 ms
constexpr std::size_t osensorframeMAX_FRAMES = 16;
constexpr longword oframeMAX_NUMBER = 0x0ffffff0;

using OFbkImageLayer = int;
constexpr OFbkImageLayer ofbkimageLAYER_H = 0;
constexpr OFbkImageLayer ofbkimageLAYER_M = 1;
constexpr OFbkImageLayer ofbkimageLAYER_L = 2;
constexpr OFbkImageLayer ofbkimageLAYER_C = 3;

// True on the robot and in a 32-bit build: there the sizes must be the robot's.
constexpr bool odataROBOTS_POINTERS = sizeof(void*) == 4;

struct ODataVectorInfo {
  MemoryRegionID memRegionID;
  void* physAddr;
  std::size_t offset;
  std::size_t totalSize;
  ODataType type;
  std::size_t infoOffset;
  std::size_t infoSize;
  std::size_t maxNumData;
  std::size_t numData;
  longword syncKey;
  longword wait;  // 8 ms frames until the start
  std::size_t optOffset;
  std::size_t optSize;
  longword padding[3];
  byte optional[128];
};
static_assert(!odataROBOTS_POINTERS || sizeof(ODataVectorInfo) == 192, "openr.md 3.4");

struct OSensorFrameInfo {
  ODataType type;
  OPrimitiveID primitiveID;
  longword frameNumber;  // of the first frame, in 8 ms
  std::size_t numFrames;
  std::size_t frameSize;
  std::size_t dataOffset;
  std::size_t dataSize;
  longword padding[1];

  void Set(ODataType dataType, OPrimitiveID id, std::size_t frames) {
    type = dataType;
    primitiveID = id;
    numFrames = frames;
  }
};
static_assert(!odataROBOTS_POINTERS || sizeof(OSensorFrameInfo) == 32, "openr.md 3.4");

struct OSensorValue {
  slongword value;
  word signal;
  word padding[5];
};
static_assert(sizeof(OSensorValue) == 16, "openr.md 3.4");

// With constructors: memory may not be copied into it (openr-measured.md 1).
struct OJointValue {
  slongword value;  // microradians
  word signal;
  sword pwmDuty;
  slongword refValue;
  word refSignal;
  word padding[1];

  OJointValue() {}  // NOLINT(modernize-use-equals-default): the robot's leaves all as it is
  OJointValue(slongword angle, word raw, sword duty, slongword wished, word rawWished)
      : value(angle), signal(raw), pwmDuty(duty), refValue(wished), refSignal(rawWished) {}
};
static_assert(sizeof(OJointValue) == 16, "openr.md 3.4");

// Types of their own, with the fields of an OSensorValue.
struct OAcceleration {
  slongword value;  // um/s^2
  word signal;
  word padding[5];
};
struct OLength {
  slongword value;  // um
  word signal;
  word padding[5];
};
using OSwitchValue = longword;
constexpr OSwitchValue oswitchOFF = 0;
constexpr OSwitchValue oswitchON = 1;
struct OSwitchStatus {
  OSwitchValue value;
  word signal;
  word padding[5];
};
static_assert(sizeof(OAcceleration) == 16 && sizeof(OLength) == 16 && sizeof(OSwitchStatus) == 16,
              "openr-measured.md 2");

struct OSensorFrameData {
  OSensorValue frame[osensorframeMAX_FRAMES];
};
static_assert(sizeof(OSensorFrameData) == 256, "openr.md 3.4");

struct OSensorFrameVectorData {
  ODataVectorInfo vectorInfo;
  OSensorFrameInfo info[1];

  void SetNumData(std::size_t count) { vectorInfo.numData = count; }
  OSensorFrameInfo* GetInfo(int i) { return info + i; }
  OSensorFrameData* GetData(int i) {
    byte* start = reinterpret_cast<byte*>(this);
    return reinterpret_cast<OSensorFrameData*>(start + GetInfo(i)->dataOffset);
  }
};
static_assert(!odataROBOTS_POINTERS || sizeof(OSensorFrameVectorData) == 224,
              "openr-measured.md 2");

struct OCommandInfo {
  ODataType type;
  OPrimitiveID primitiveID;
  longword frameNumber;
  std::size_t numFrames;
  std::size_t frameSize;
  std::size_t dataOffset;
  std::size_t dataSize;
  longword padding[1];

  void Set(ODataType dataType, OPrimitiveID id, std::size_t frames) {
    type = dataType;
    primitiveID = id;
    numFrames = frames;
  }
};
static_assert(!odataROBOTS_POINTERS || sizeof(OCommandInfo) == 32, "openr.md 3.4");

struct OCommandValue {
  slongword value[2];
};

struct OJointCommandValue2 {
  slongword value;  // microradians
  slongword padding;
};

using OLEDValue = longword;
constexpr OLEDValue oledOFF = 0;
constexpr OLEDValue oledON = 1;

struct OLEDCommandValue2 {
  OLEDValue led;
  word period;  // in 8 ms
  word reserved;
};

using OLED3Mode = word;
constexpr OLED3Mode oled3_MODE_UNDEF = 0xffff;
constexpr OLED3Mode oled3_MODE_A = 0;
constexpr OLED3Mode oled3_MODE_B = 1;

struct OLEDCommandValue3 {
  sword intensity;  // 0..255
  OLED3Mode mode;
  word period;  // in 8 ms
  word reserved;
};
using OJointValue4 = longword;
constexpr OJointValue4 ojoint4_STATE0 = 0;
constexpr OJointValue4 ojoint4_STATE1 = 1;

struct OJointCommandValue4 {
  OJointValue4 value;
  word period;  // in 8 ms
  word reserved;
};
static_assert(sizeof(OCommandValue) == 8 && sizeof(OJointCommandValue2) == 8 &&
                  sizeof(OLEDCommandValue2) == 8 && sizeof(OLEDCommandValue3) == 8 &&
                  sizeof(OJointCommandValue4) == 8,
              "frameSize of commands, openr.md 5.3");

struct OCommandData {
  OCommandValue value[ocommandMAX_FRAMES];
};
static_assert(sizeof(OCommandData) == 128, "openr.md 3.4");

struct OCommandVectorData {
  ODataVectorInfo vectorInfo;
  OCommandInfo info[1];

  void SetNumData(std::size_t count) { vectorInfo.numData = count; }
  OCommandInfo* GetInfo(int i) { return info + i; }
  OCommandData* GetData(int i) {
    byte* start = reinterpret_cast<byte*>(this);
    return reinterpret_cast<OCommandData*>(start + GetInfo(i)->dataOffset);
  }
};
static_assert(!odataROBOTS_POINTERS || sizeof(OCommandVectorData) == 224, "openr-measured.md 2");

struct OFbkImageInfo {
  ODataType type;
  OPrimitiveID primitiveID;
  longword frameNumber;
  std::size_t dataOffset;
  std::size_t dataSize;
  std::size_t width;
  std::size_t height;
  std::size_t padding[1];
};
static_assert(!odataROBOTS_POINTERS || sizeof(OFbkImageInfo) == 32, "openr.md 3.4");

// Has no SetNumData: only the system makes one.
struct OFbkImageVectorData {
  ODataVectorInfo vectorInfo;
  OFbkImageInfo info[1];

  // Of all its layers.
  void SetPrimitiveID(OPrimitiveID id) {
    for (std::size_t i = 0; i < vectorInfo.numData; ++i) info[i].primitiveID = id;
  }
  OFbkImageInfo* GetInfo(int i) { return info + i; }
  byte* GetData(int i) { return reinterpret_cast<byte*>(this) + GetInfo(i)->dataOffset; }
};
static_assert(!odataROBOTS_POINTERS || sizeof(OFbkImageVectorData) == 224, "openr-measured.md 2");
