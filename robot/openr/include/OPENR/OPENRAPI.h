// SPDX-License-Identifier: Apache-2.0
// The calls that an object makes to the robot (openr.md 5.5). Order that the robot wants: open the
// primitives, power the motors, enable the gains, send commands.
#pragma once

#include "OPENR/ODataFormats.h"
#include "OPENR/OPENR.h"
#include "OPENR/OPENRMessages.h"
#include "OPENR/OPower.h"

using OPrimitiveRequest = longword;
constexpr OPrimitiveRequest oprmreqSPEAKER_MUTE_ON = 128;
constexpr OPrimitiveRequest oprmreqSPEAKER_MUTE_OFF = 129;
constexpr OPrimitiveRequest oprmreqSPEAKER_SET_VOLUME = 130;
constexpr OPrimitiveRequest oprmreqSPEAKER_SET_SOUND_TYPE = 131;
constexpr OPrimitiveRequest oprmreqCAM_SET_WHITE_BALANCE = 384;
constexpr OPrimitiveRequest oprmreqCAM_SET_GAIN = 385;
constexpr OPrimitiveRequest oprmreqCAM_SET_SHUTTER_SPEED = 386;
constexpr OPrimitiveRequest oprmreqCAM_AE_ON = 388;
constexpr OPrimitiveRequest oprmreqCAM_AE_OFF = 389;
constexpr OPrimitiveRequest oprmreqCAM_AWB_ON = 390;
constexpr OPrimitiveRequest oprmreqCAM_AWB_OFF = 391;

constexpr longword ocamparamWB_INDOOR_MODE = 1;   // 2856 K
constexpr longword ocamparamWB_OUTDOOR_MODE = 2;  // 6500 K
constexpr longword ocamparamWB_FL_MODE = 3;       // 5000 K
constexpr longword ocamparamGAIN_LOW = 1;         // -6 dB
constexpr longword ocamparamGAIN_MID = 2;         // 0 dB
constexpr longword ocamparamGAIN_HIGH = 3;        // +6 dB
constexpr longword ocamparamSHUTTER_SLOW = 1;     // 1/50 s
constexpr longword ocamparamSHUTTER_MID = 2;      // 1/100 s
constexpr longword ocamparamSHUTTER_FAST = 3;     // 1/200 s

struct OPrimitiveControl_CameraParam {
  longword camparam;

  OPrimitiveControl_CameraParam() : camparam(0) {}
  // NOLINTNEXTLINE(google-explicit-constructor,hicpp-explicit-conversions): so on the robot
  OPrimitiveControl_CameraParam(longword value) : camparam(value) {}
};
static_assert(sizeof(OPrimitiveControl_CameraParam) == 4, "openr.md 5.5");

namespace OPENR {

OStatus OpenPrimitive(const char* locator, OPrimitiveID* id);
OStatus ClosePrimitive(OPrimitiveID id);
OStatus ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, void* param,
                         std::size_t paramSize, void* result, std::size_t resultSize);

OStatus NewCommandVectorData(std::size_t count, MemoryRegionID* memID, OCommandVectorData** data);
OStatus DeleteCommandVectorData(MemoryRegionID memID);

// Six words: proportional, integral, derivative gain, and the shift of each.
OStatus EnableJointGain(OPrimitiveID id);
OStatus DisableJointGain(OPrimitiveID id);
OStatus SetJointGain(OPrimitiveID id, word pg, word ig, word dg, word ps, word is, word ds);
OStatus GetJointGain(OPrimitiveID id, word* pg, word* ig, word* dg, word* ps, word* is, word* ds);

OStatus GetJointValue(OPrimitiveID id, OJointValue* value);
OStatus GetSensorValue(OPrimitiveID id, OSensorValue* value);

OStatus SetMotorPower(OPower power);
// The whole robot, until one of the conditions holds. Objects get DoStop and DoDestroy first.
OStatus Shutdown(const OBootCondition& condition);
// Waits for another object's answer (openr-measured.md 2): not for a loop.
OStatus GetPowerStatus(OPowerStatus* status);
// From now on an OPowerStatusMessage comes to the entry when a bit that `watched` has set changes,
// or a value that it does not exclude.
OStatus ObservePowerStatus(const OPowerStatus& watched, const OServiceEntry& entry);
OStatus UnobservePowerStatus(const OServiceEntry& entry);
OStatus GetRobotDesign(char* design);  // "ERS-7"; room for 32 characters

}  // namespace OPENR
