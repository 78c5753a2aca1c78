// SPDX-License-Identifier: Apache-2.0
// Out of line, as on the robot (openr-measured.md 2).
#include <OPENR/OPower.h>

OPowerStatus::OPowerStatus()
    : robotStatus(0),
      batteryStatus(0),
      remainingCapacity(0),
      temperature(0),
      fullyChargedCapacity(0),
      voltage(0),
      current(0),
      timeDif(0),
      volume(0) {}

OPowerStatus::OPowerStatus(const OPowerStatus& other) { *this = other; }

OPowerStatus& OPowerStatus::operator=(const OPowerStatus& other) = default;

void OPowerStatus::Set(longword robotBits, word batteryBits, word capacity, word heat, char zone,
                       byte loudness) {
  robotStatus = robotBits;
  batteryStatus = batteryBits;
  remainingCapacity = capacity;
  temperature = heat;
  timeDif = zone;
  volume = loudness;
}

OBootCondition::OBootCondition(word bits)
    : bitmap(bits), bootTime(0), bootTimeType(0), vibrationLevel(0) {}

OBootCondition::OBootCondition(const OBootCondition& other) = default;

OBootCondition& OBootCondition::operator=(const OBootCondition& other) = default;
