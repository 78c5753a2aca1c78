// SPDX-License-Identifier: Apache-2.0
// Layout of everything that travels between an object and the robot's hardware (openr.md 5.3). A
// vector is ODataVectorInfo, then one info per primitive, then the data blocks that the infos point
// to. Sizes are those measured with the real headers (openr.md 3.4).
#pragma once

#include "OPENR/OPENR.h"

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
constexpr ODataType odataSENSOR_VECTOR = 1025;
constexpr ODataType odataSOUND_VECTOR = 1026;
constexpr ODataType odataFBKIMAGE_VECTOR = 1027;
constexpr ODataType odataCDT_VECTOR = 1028;

constexpr std::size_t ocommandMAX_FRAMES = 16;  // 128 ms
constexpr std::size_t osensorframeMAX_FRAMES = 16;
constexpr longword oframeMAX_NUMBER = 0x0ffffff0;

using OFbkImageLayer = longword;
constexpr OFbkImageLayer ofbkimageLAYER_H = 0;
constexpr OFbkImageLayer ofbkimageLAYER_M = 1;
constexpr OFbkImageLayer ofbkimageLAYER_L = 2;
constexpr OFbkImageLayer ofbkimageLAYER_C = 3;

struct ODataVectorInfo {
  MemoryRegionID memRegionID;
  longword physAddr;
  longword offset;
  longword totalSize;
  ODataType type;
  longword infoOffset;
  longword infoSize;
  longword maxNumData;
  longword numData;
  longword syncKey;
  longword wait;  // 8 ms frames until the start
  longword optOffset;
  longword optSize;
  longword padding[3];
  byte optional[128];
};
static_assert(sizeof(ODataVectorInfo) == 192, "openr.md 3.4");

// The methods that all vectors have. T is the info, Data what its dataOffset points to.
template <class T, class Data>
struct ODataVector {
  ODataVectorInfo vectorInfo;

  void SetNumData(std::size_t count) { vectorInfo.numData = static_cast<longword>(count); }
  T* GetInfo(std::size_t i) const { return reinterpret_cast<T*>(at(vectorInfo.infoOffset)) + i; }
  Data* GetData(std::size_t i) const { return reinterpret_cast<Data*>(at(GetInfo(i)->dataOffset)); }

 private:
  byte* at(longword offset) const {
    return const_cast<byte*>(reinterpret_cast<const byte*>(this)) + offset;
  }
};

struct OSensorFrameInfo {
  ODataType type;
  OPrimitiveID primitiveID;
  longword frameNumber;  // of the first frame, in 8 ms
  longword numFrames;
  longword frameSize;
  longword dataOffset;
  longword dataSize;
  longword padding;
};
static_assert(sizeof(OSensorFrameInfo) == 32, "openr.md 3.4");

struct OSensorValue {
  slongword value;
  word signal;
  word padding[5];
};
static_assert(sizeof(OSensorValue) == 16, "openr.md 3.4");

struct OJointValue {
  slongword value;  // microradians
  word signal;
  sword pwmDuty;
  slongword refValue;
  word refSignal;
  word padding;
};
static_assert(sizeof(OJointValue) == 16, "openr.md 3.4");

using OAcceleration = OSensorValue;  // value in um/s^2
using OLength = OSensorValue;        // value in um
using OSwitchStatus = OSensorValue;  // value 0 or 1

struct OSensorFrameData {
  OSensorValue frame[osensorframeMAX_FRAMES];
};
static_assert(sizeof(OSensorFrameData) == 256, "openr.md 3.4");

using OSensorFrameVectorData = ODataVector<OSensorFrameInfo, OSensorFrameData>;

struct OCommandInfo {
  ODataType type;
  OPrimitiveID primitiveID;
  longword frameNumber;
  longword numFrames;
  longword frameSize;
  longword dataOffset;
  longword dataSize;
  longword padding;

  void Set(ODataType dataType, OPrimitiveID id, std::size_t frames) {
    type = dataType;
    primitiveID = id;
    numFrames = static_cast<longword>(frames);
  }
};
static_assert(sizeof(OCommandInfo) == 32, "openr.md 3.4");

struct OCommandValue {
  longword words[2];
};

struct OJointCommandValue2 {
  slongword value;  // microradians
  slongword padding;
};

using OLEDValue = slongword;
constexpr OLEDValue oledOFF = 0;
constexpr OLEDValue oledON = 1;

struct OLEDCommandValue2 {
  OLEDValue led;
  word period;  // in 8 ms
  word reserved;
};

using OLED3Mode = word;
constexpr OLED3Mode oled3_MODE_A = 0;
constexpr OLED3Mode oled3_MODE_B = 1;

struct OLEDCommandValue3 {
  sword intensity;  // 0..255
  OLED3Mode mode;
  word period;  // in 8 ms
  word reserved;
};
using OJointValue4 = slongword;
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

using OCommandVectorData = ODataVector<OCommandInfo, OCommandData>;

struct OFbkImageInfo {
  ODataType type;
  OPrimitiveID primitiveID;
  longword frameNumber;
  longword dataOffset;
  longword dataSize;
  longword width;
  longword height;
  longword padding;
};
static_assert(sizeof(OFbkImageInfo) == 32, "openr.md 3.4");

using OFbkImageVectorData = ODataVector<OFbkImageInfo, byte>;

struct OPowerStatus {
  longword robotStatus;
  longword batteryStatus;
  word remainingCapacity;  // percent
  word temperature;
  word voltage;
  sword current;
  longword reserved;
};
static_assert(sizeof(OPowerStatus) == 20, "openr.md 3.4");
