// SPDX-License-Identifier: Apache-2.0
// The ERS-7's primitives by their OPEN-R locators (openr.md 5.6), and how their raw values relate
// to Kelpie's units. Used by the agent to open them and by the host to offer them.
#pragma once

#include <Types.h>

#include <array>
#include <cstddef>

#include "robot/core/types/Joints.h"

namespace kelpie::openr {

// In the order of Joint.
constexpr std::array<const char*, kJointCount> kJointLocators = {
    "PRM:/r1/c1-Joint2:11",          "PRM:/r1/c1/c2-Joint2:12", "PRM:/r1/c1/c2/c3-Joint2:13",
    "PRM:/r1/c1/c2/c3/c4-Joint2:14", "PRM:/r2/c1-Joint2:21",    "PRM:/r2/c1/c2-Joint2:22",
    "PRM:/r2/c1/c2/c3-Joint2:23",    "PRM:/r3/c1-Joint2:31",    "PRM:/r3/c1/c2-Joint2:32",
    "PRM:/r3/c1/c2/c3-Joint2:33",    "PRM:/r4/c1-Joint2:41",    "PRM:/r4/c1/c2-Joint2:42",
    "PRM:/r4/c1/c2/c3-Joint2:43",    "PRM:/r5/c1-Joint2:51",    "PRM:/r5/c1/c2-Joint2:52",
    "PRM:/r5/c1/c2/c3-Joint2:53",    "PRM:/r6/c1-Joint2:61",    "PRM:/r6/c2-Joint2:62",
};

enum class Sensor {
  headNear,
  headFar,
  chest,
  // a1, a2, a3, named by where they count positive: a1 is +g on its nose, a2 +g on its right side,
  // a3 +g on its back and -g when it stands (2005 release, CommonSense.cc; Tekkotsu, ERS7Info.h).
  accelerationBack,
  accelerationLeft,
  accelerationDown,
  pawLeftFront,  // in the order of LegId
  pawLeftHind,
  pawRightFront,
  pawRightHind,
  chin,
  headTouch,
  backRear,
  backMiddle,
  backFront,
};
constexpr std::size_t kSensorCount = 15;
constexpr std::size_t index(Sensor sensor) { return static_cast<std::size_t>(sensor); }

// In the order of Sensor.
constexpr std::array<const char*, kSensorCount> kSensorLocators = {
    "PRM:/r1/c1/c2/c3/p1-Sensor:p1",
    "PRM:/r1/c1/c2/c3/p2-Sensor:p2",
    "PRM:/p1-Sensor:p1",
    "PRM:/a1-Sensor:a1",
    "PRM:/a2-Sensor:a2",
    "PRM:/a3-Sensor:a3",
    "PRM:/r2/c1/c2/c3/c4-Sensor:24",
    "PRM:/r3/c1/c2/c3/c4-Sensor:34",
    "PRM:/r4/c1/c2/c3/c4-Sensor:44",
    "PRM:/r5/c1/c2/c3/c4-Sensor:54",
    "PRM:/r1/c1/c2/c3/c4/s5-Sensor:s5",
    "PRM:/r1/c1/c2/c3/t1-Sensor:t1",
    "PRM:/t2-Sensor:t2",
    "PRM:/t3-Sensor:t3",
    "PRM:/t4-Sensor:t4",
};

// Bit i of every `leds` word is LED i of this table: the first six are on or off (LED2: head colour
// and white, mode red, green, blue, wireless), the rest have an intensity (LED3: face 1-14, then
// back front, middle and rear, each colour and white).
constexpr std::size_t kSwitchedLeds = 6;
constexpr std::size_t kLedCount = 26;
constexpr std::array<const char*, kLedCount> kLedLocators = {
    "PRM:/r1/c1/c2/c3/l1-LED2:l1",
    "PRM:/r1/c1/c2/c3/l2-LED2:l2",
    "PRM:/r1/c1/c2/c3/l3-LED2:l3",
    "PRM:/r1/c1/c2/c3/l4-LED2:l4",
    "PRM:/r1/c1/c2/c3/l5-LED2:l5",
    "PRM:/r1/c1/c2/c3/l6-LED2:l6",
    "PRM:/r1/c1/c2/c3/la-LED3:la",
    "PRM:/r1/c1/c2/c3/lb-LED3:lb",
    "PRM:/r1/c1/c2/c3/lc-LED3:lc",
    "PRM:/r1/c1/c2/c3/ld-LED3:ld",
    "PRM:/r1/c1/c2/c3/le-LED3:le",
    "PRM:/r1/c1/c2/c3/lf-LED3:lf",
    "PRM:/r1/c1/c2/c3/lg-LED3:lg",
    "PRM:/r1/c1/c2/c3/lh-LED3:lh",
    "PRM:/r1/c1/c2/c3/li-LED3:li",
    "PRM:/r1/c1/c2/c3/lj-LED3:lj",
    "PRM:/r1/c1/c2/c3/lk-LED3:lk",
    "PRM:/r1/c1/c2/c3/ll-LED3:ll",
    "PRM:/r1/c1/c2/c3/lm-LED3:lm",
    "PRM:/r1/c1/c2/c3/ln-LED3:ln",
    "PRM:/lu-LED3:lu",
    "PRM:/lv-LED3:lv",
    "PRM:/lw-LED3:lw",
    "PRM:/lx-LED3:lx",
    "PRM:/ly-LED3:ly",
    "PRM:/lz-LED3:lz",
};

// Left and right; up or not. An ear that is held up for long wears its solenoid (openr.md 5.6).
constexpr std::size_t kEarCount = 2;
constexpr std::array<const char*, kEarCount> kEarLocators = {
    "PRM:/r1/c1/c2/c3/e5-Joint4:15",
    "PRM:/r1/c1/c2/c3/e6-Joint4:16",
};

constexpr const char* kCameraLocator = "PRM:/r1/c1/c2/c3/i1-FbkImageSensor:F1";

// What the sensors can tell; beyond that they saturate.
struct SensorRange {
  double min;
  double max;
};
constexpr SensorRange kHeadNearRange = {5.0, 50.0};              // cm
constexpr SensorRange kHeadFarRange = {20.0, 150.0};             // cm
constexpr SensorRange kChestRange = {10.0, 90.0};                // cm
constexpr SensorRange kAccelerationRange = {-1961.33, 1961.33};  // cm/s2
constexpr SensorRange kHeadTouchRange = {0.0, 80.0};

// Back sensors: pressed from `on` upwards, until below `off`.
struct TouchThresholds {
  slongword on;
  slongword off;
};
constexpr TouchThresholds kBackFrontTouch = {12, 12};
constexpr TouchThresholds kBackMiddleTouch = {14, 10};
constexpr TouchThresholds kBackRearTouch = {14, 10};

// Raw units at the border, and Kelpie's.
constexpr double kMicroradian = 1e-6;  // rad
constexpr double kMicrometre = 1e-4;   // cm, and um/s2 in cm/s2
// Full motor duty. Not in the documents at hand; 512 is what other ERS-7 code divides by.
constexpr double kFullDuty = 512.0;

}  // namespace kelpie::openr
