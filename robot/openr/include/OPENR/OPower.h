// SPDX-License-Identifier: Apache-2.0
// Power of the motors and of the battery (openr.md 5.5; openr-measured.md 2 for the layout). The
// numbers of the bits are those of the SDK's OPower.h; only the bits that mean something to a
// soccer player are named here.
#pragma once

#include <cstddef>

#include "Types.h"

using OPower = bool;
constexpr OPower opowerON = true;
constexpr OPower opowerOFF = false;

// Bits of robotStatus.
constexpr longword orsbPAUSE = 0x1;  // the pause switch was pressed
constexpr longword orsbMOTOR_POWER = 0x2;
constexpr longword orsbEX_POWER_CONNECTED = 0x20;
constexpr longword orsbBATTERY_CONNECTED = 0x40;
constexpr longword orsbBATTERY_CAPACITY_LOW = 0x200;
constexpr longword orsbBATTERY_OVER_CURRENT = 0x400;
constexpr longword orsbBATTERY_OVER_TEMP_DISCHARGING = 0x800;
constexpr longword orsbERROR_OF_FAN = 0x10000;
constexpr longword orsbALL = 0x1fffffff;

// Bits of batteryStatus.
constexpr word obsbFULLY_DISCHARGED = 0x10;
constexpr word obsbREMAINING_CAPACITY_ALARM = 0x200;
constexpr word obsbTERMINATED_DISCHARGING_ALARM = 0x800;
constexpr word obsbOVER_TEMP_ALARM = 0x1000;
constexpr word obsbALL = 0xffff;

// What may switch the robot on again.
constexpr word obcbBOOT_TIMER = 0x1;
constexpr word obcbPAUSE_SW = 0x4;  // the pause switch

// For ObservePowerStatus: a message at each change of the value, or none because of it.
constexpr word opsoREMAINING_CAPACITY_NOTIFY_EVERY_CHANGE = 0xffff;
constexpr word opsoREMAINING_CAPACITY_NOT_NOTIFY = 0xfffe;
constexpr word opsoTEMPERATURE_NOTIFY_EVERY_CHANGE = 0xffff;
constexpr word opsoTEMPERATURE_NOT_NOTIFY = 0xfffe;
constexpr sbyte opsoTIME_DIF_NOT_NOTIFY = 0x7e;
constexpr byte opsoVOLUME_NOT_NOTIFY = 0xfe;

struct OPowerStatus {
  longword robotStatus;
  word batteryStatus;
  word remainingCapacity;  // percent
  word temperature;
  word fullyChargedCapacity;
  word voltage;
  sword current;  // mA; its sense is not documented
  sbyte timeDif;
  byte volume;

  OPowerStatus();
  OPowerStatus(const OPowerStatus& other);
  OPowerStatus& operator=(const OPowerStatus& other);
  ~OPowerStatus() = default;

  // What ObservePowerStatus shall tell of.
  void Set(longword robotBits, word batteryBits, word capacity, word heat, char zone,
           byte loudness);
};
static_assert(sizeof(OPowerStatus) == 20, "openr.md 3.4");
static_assert(offsetof(OPowerStatus, batteryStatus) == 4 &&
                  offsetof(OPowerStatus, remainingCapacity) == 6 &&
                  offsetof(OPowerStatus, temperature) == 8 &&
                  offsetof(OPowerStatus, fullyChargedCapacity) == 10 &&
                  offsetof(OPowerStatus, voltage) == 12 && offsetof(OPowerStatus, current) == 14 &&
                  offsetof(OPowerStatus, timeDif) == 16 && offsetof(OPowerStatus, volume) == 17,
              "openr-measured.md 2");

struct OBootCondition {
  word bitmap;
  slongword bootTime;  // s
  longword bootTimeType;
  byte vibrationLevel;

  explicit OBootCondition(word bits);
  OBootCondition(const OBootCondition& other);
  OBootCondition& operator=(const OBootCondition& other);
  ~OBootCondition() = default;
};
