// SPDX-License-Identifier: Apache-2.0
// What a real ERS-7 tells and takes, as public sources outside Kelpie have it: every joint, sensor,
// light, ear and power bit in the robot's own sign and unit. Neither the agent nor the world is
// made from these rows; tests hold both against them, and docs/robot-contract.md is written from
// them. Left and right are the robot's own.
#pragma once

#include <Types.h>

#include <array>

#include "robot/core/types/Joints.h"
#include "robot/openr/Ers7Primitives.h"

namespace kelpie::openr {

// Degrees in the robot's sign; raw values are microradians.
struct JointRow {
  const char* locator;
  const char* name;
  const char* positive;  // what a greater angle does
  double min;
  double max;
  double standing;  // with its head ahead, legs as the 2005 team's get-up leaves them
  const char* source;
};

// In the order of Joint.
constexpr const char* kHead = "ERS7Info.h";
constexpr const char* kFrontJ1 = "ERS7Info.h, MovingLegs7.h, JointLimit.h, getupf.pos";
constexpr const char* kHindJ1 = kFrontJ1;
constexpr const char* kElevator = "ERS7Info.h, MovingLegs7.h";
constexpr const char* kFrontForward = "paw forward, away from the body";
constexpr const char* kHindBackward = "paw backward, away from the body";
constexpr const char* kPawOut = "paw out and up, away from the body";
constexpr const char* kFrontBends = "bends, the front paw goes forward";
constexpr const char* kHindBends = "bends, the hind paw goes backward";
constexpr std::array<JointRow, kJointCount> kJointRows = {{
    {"PRM:/r1/c1-Joint2:11", "neck tilt", "looks up", -75, 0, 0, kHead},
    {"PRM:/r1/c1/c2-Joint2:12", "head pan", "looks left", -88, 88, 0, kHead},
    {"PRM:/r1/c1/c2/c3-Joint2:13", "head nod", "looks up", -15, 45, 0, kHead},
    {"PRM:/r1/c1/c2/c3/c4-Joint2:14", "mouth", "closes (open is -55)", -55, -3, -3,
     "ERS7Info.h, IndicatorsDef.h"},
    {"PRM:/r2/c1-Joint2:21", "left front J1", kFrontForward, -115, 130, -15, kFrontJ1},
    {"PRM:/r2/c1/c2-Joint2:22", "left front J2", kPawOut, -10, 88, 0, kElevator},
    {"PRM:/r2/c1/c2/c3-Joint2:23", "left front J3", kFrontBends, -25, 122, 60, kElevator},
    {"PRM:/r3/c1-Joint2:31", "left hind J1", kHindBackward, -130, 115, -20, kHindJ1},
    {"PRM:/r3/c1/c2-Joint2:32", "left hind J2", kPawOut, -10, 88, 0, kElevator},
    {"PRM:/r3/c1/c2/c3-Joint2:33", "left hind J3", kHindBends, -25, 122, 90, kElevator},
    {"PRM:/r4/c1-Joint2:41", "right front J1", kFrontForward, -115, 130, -15, kFrontJ1},
    {"PRM:/r4/c1/c2-Joint2:42", "right front J2", kPawOut, -10, 88, 0, kElevator},
    {"PRM:/r4/c1/c2/c3-Joint2:43", "right front J3", kFrontBends, -25, 122, 60, kElevator},
    {"PRM:/r5/c1-Joint2:51", "right hind J1", kHindBackward, -130, 115, -20, kHindJ1},
    {"PRM:/r5/c1/c2-Joint2:52", "right hind J2", kPawOut, -10, 88, 0, kElevator},
    {"PRM:/r5/c1/c2/c3-Joint2:53", "right hind J3", kHindBends, -25, 122, 90, kElevator},
    {"PRM:/r6/c1-Joint2:61", "tail tilt", "not agreed (see below)", 5, 60, 30,
     "ERS7Info.h, IndicatorsDef.h"},
    {"PRM:/r6/c2-Joint2:62", "tail pan", "points right", -45, 45, 0, "ERS7Info.h, IndicatorsDef.h"},
}};

// Raw values.
struct SensorRow {
  const char* locator;
  const char* name;
  const char* unit;
  const char* meaning;
  slongword min;
  slongword max;
  const char* standing;
  const char* source;
};

// In the order of Sensor.
constexpr const char* kAhead = "what is ahead";
constexpr const char* kSwitch = "0 or 1";
constexpr const char* kPressure = "pressure";
constexpr const char* kSensors = "ERS7Info.h, SensorObserver7.h";
constexpr const char* kGravity = "CommonSense.cc, ERS7Info.h";
constexpr slongword kTwoG = 19613300;
constexpr slongword kOpenEnded = 0x7fffffff;  // the sources have no greatest value
constexpr std::array<SensorRow, kSensorCount> kSensorRows = {{
    {"PRM:/r1/c1/c2/c3/p1-Sensor:p1", "head, near", "um", "distance", 50000, 500000, kAhead,
     kSensors},
    {"PRM:/r1/c1/c2/c3/p2-Sensor:p2", "head, far", "um", "distance", 200000, 1500000, kAhead,
     kSensors},
    {"PRM:/p1-Sensor:p1", "chest", "um", "distance", 100000, 900000, kAhead, kSensors},
    {"PRM:/a1-Sensor:a1", "acceleration, front and back", "um/s2",
     "+g on its nose, -g sitting on its tail", -kTwoG, kTwoG, "0", kGravity},
    {"PRM:/a2-Sensor:a2", "acceleration, right and left", "um/s2",
     "+g on its right side, -g on its left side", -kTwoG, kTwoG, "0", kGravity},
    {"PRM:/a3-Sensor:a3", "acceleration, up and down", "um/s2", "+g on its back, -g on its feet",
     -kTwoG, kTwoG, "-9806650", kGravity},
    {"PRM:/r2/c1/c2/c3/c4-Sensor:24", "paw, left front", kSwitch, "1 pressed", 0, 1, "1", kSensors},
    {"PRM:/r3/c1/c2/c3/c4-Sensor:34", "paw, left hind", kSwitch, "1 pressed", 0, 1, "1", kSensors},
    {"PRM:/r4/c1/c2/c3/c4-Sensor:44", "paw, right front", kSwitch, "1 pressed", 0, 1, "1",
     kSensors},
    {"PRM:/r5/c1/c2/c3/c4-Sensor:54", "paw, right hind", kSwitch, "1 pressed", 0, 1, "1", kSensors},
    {"PRM:/r1/c1/c2/c3/c4/s5-Sensor:s5", "chin", kSwitch, "1 pressed", 0, 1, "0", kSensors},
    {"PRM:/r1/c1/c2/c3/t1-Sensor:t1", "head", kPressure, "touched above 9", 0, 80, "0",
     "openr.md 5.6, CommonSense.cc"},
    {"PRM:/t2-Sensor:t2", "back, rear", kPressure, "touched from 14 until below 10", 0, kOpenEnded,
     "0", "openr.md 5.6, SensorObserver7.h"},
    {"PRM:/t3-Sensor:t3", "back, middle", kPressure, "touched from 14 until below 10", 0,
     kOpenEnded, "0", "openr.md 5.6, SensorObserver7.h"},
    {"PRM:/t4-Sensor:t4", "back, front", kPressure, "touched from 12", 0, kOpenEnded, "0",
     "openr.md 5.6, SensorObserver7.h"},
}};

// Switched (LED2) or with an intensity of 0 to 255 (LED3).
struct LightRow {
  const char* locator;
  const char* place;
};

// In the order of the bits of `leds`.
constexpr std::array<LightRow, kLedCount> kLightRows = {{
    {"PRM:/r1/c1/c2/c3/l1-LED2:l1", "over the head's button, orange"},
    {"PRM:/r1/c1/c2/c3/l2-LED2:l2", "over the head's button, white"},
    {"PRM:/r1/c1/c2/c3/l3-LED2:l3", "over both ears, red"},
    {"PRM:/r1/c1/c2/c3/l4-LED2:l4", "over both ears, green"},
    {"PRM:/r1/c1/c2/c3/l5-LED2:l5", "over both ears, blue"},
    {"PRM:/r1/c1/c2/c3/l6-LED2:l6", "back of the head, blue (wireless)"},
    {"PRM:/r1/c1/c2/c3/la-LED3:la", "face 1: bottom right"},
    {"PRM:/r1/c1/c2/c3/lb-LED3:lb", "face 2: bottom left"},
    {"PRM:/r1/c1/c2/c3/lc-LED3:lc", "face 3: middle right"},
    {"PRM:/r1/c1/c2/c3/ld-LED3:ld", "face 4: middle left"},
    {"PRM:/r1/c1/c2/c3/le-LED3:le", "face 5: middle, between 3 and 12"},
    {"PRM:/r1/c1/c2/c3/lf-LED3:lf", "face 6: middle, between 12 and 4"},
    {"PRM:/r1/c1/c2/c3/lg-LED3:lg", "face 7: top right"},
    {"PRM:/r1/c1/c2/c3/lh-LED3:lh", "face 8: top left"},
    {"PRM:/r1/c1/c2/c3/li-LED3:li", "face 9"},
    {"PRM:/r1/c1/c2/c3/lj-LED3:lj", "face 10"},
    {"PRM:/r1/c1/c2/c3/lk-LED3:lk", "face 11"},
    {"PRM:/r1/c1/c2/c3/ll-LED3:ll", "face 12: the middle"},
    {"PRM:/r1/c1/c2/c3/lm-LED3:lm", "face 13: two lamps, one each side"},
    {"PRM:/r1/c1/c2/c3/ln-LED3:ln", "face 14: two lamps, one each side"},
    {"PRM:/lu-LED3:lu", "back, front: blue"},
    {"PRM:/lv-LED3:lv", "back, front: white"},
    {"PRM:/lw-LED3:lw", "back, middle: orange"},
    {"PRM:/lx-LED3:lx", "back, middle: white"},
    {"PRM:/ly-LED3:ly", "back, rear: red"},
    {"PRM:/lz-LED3:lz", "back, rear: white"},
}};

// Left and right: state 1 is up.
constexpr std::array<const char*, kEarCount> kEarRows = {"PRM:/r1/c1/c2/c3/e5-Joint4:15",
                                                         "PRM:/r1/c1/c2/c3/e6-Joint4:16"};
constexpr const char* kCameraRow = "PRM:/r1/c1/c2/c3/i1-FbkImageSensor:F1";

// Of OPowerStatus; the numbers are OPower.h's.
struct PowerRow {
  const char* name;
  bool battery;  // a bit of batteryStatus, else of robotStatus
  longword bit;
  const char* meaning;
};
constexpr std::array<PowerRow, 9> kPowerRows = {{
    {"orsbPAUSE", false, 0x1, "the pause switch was pressed"},
    {"orsbMOTOR_POWER", false, 0x2, "the motors have power"},
    {"orsbBATTERY_CONNECTED", false, 0x40, "a battery is in"},
    {"orsbBATTERY_CAPACITY_LOW", false, 0x200, "too little is left: Sony's PowerMonitor ends"},
    {"orsbBATTERY_OVER_CURRENT", false, 0x400, "the battery gives too much current"},
    {"orsbBATTERY_OVER_TEMP_DISCHARGING", false, 0x800, "the battery is too hot"},
    {"orsbERROR_OF_FAN", false, 0x10000, "the fan stands still"},
    {"obsbTERMINATED_DISCHARGING_ALARM", true, 0x800, "the battery wants to end"},
    {"obsbOVER_TEMP_ALARM", true, 0x1000, "the battery is too hot"},
}};

}  // namespace kelpie::openr
