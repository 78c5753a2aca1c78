// SPDX-License-Identifier: Apache-2.0
// The ERS-7's body in numbers: sizes (facts-2005 sections 2.2 and 2.4, data/robot/geometry.csv),
// soft joint limits, gains and OPEN-R locators (spec openr.md 5.6). Lengths in cm, angles in
// degrees.
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/types/Joints.h"

namespace kelpie::body {

constexpr double kUpperLeg = 6.95;    // shoulder axis to knee axis, down the leg
constexpr double kKneeForward = 0.9;  // knee axis ahead of that line (behind it for hind legs)
constexpr double kKneeOut = 0.47;     // and outside it
constexpr double kLowerLegFront = 7.736;
constexpr double kLowerLegHind = 8.314;
constexpr double kPawRadius = 1.0;  // of the sphere that the lower leg ends in [chosen]
// The elbow cowl of a front leg: a rounded bar along the lower leg, behind it [chosen].
constexpr double kCowlRadius = 1.4;
constexpr double kCowlBehind = 1.1;
constexpr double kCowlBegins = 1.5;  // below the knee
constexpr double kCowlEnds = 4.5;
constexpr double kBodyLength = 13.0;          // front to hind shoulder axis
constexpr double kBodyWidth = 13.44;          // left to right shoulder axis
constexpr double kNeckAboveShoulder = 1.95;   // neck tilt axis above the front shoulder axis
constexpr double kChestDepth = 5.0;           // chest and belly below the line of the shoulder axes
constexpr double kNeckBehindShoulder = 0.25;  // and behind it
constexpr double kNeckLength = 8.0;           // neck tilt axis to nod axis (facts-2005 section 2.2)
constexpr double kFaceLength = 8.106;         // nod axis to the camera's plane
constexpr double kCameraDrop = 1.46;          // camera below the nod axis

struct JointRange {
  double min;
  double max;
};

// In the order of Joint. The robot counts a hind rotator from -130 to 115, away from the body
// (robot/agent/joints/Senses.h); forward positive it has the range of a front one.
constexpr std::array<JointRange, kJointCount> kJointRanges = {{
    {-75, 0},
    {-88, 88},
    {-15, 45},  // head
    {-55, -3},  // mouth
    {-115, 130},
    {-10, 88},
    {-25, 122},  // left front
    {-115, 130},
    {-10, 88},
    {-25, 122},  // left hind
    {-115, 130},
    {-10, 88},
    {-25, 122},  // right front
    {-115, 130},
    {-10, 88},
    {-25, 122},  // right hind
    {5, 60},
    {-45, 45},  // tail
}};

// The body is in the way of the shoulder: its lower limit rises as the rotator leaves the middle.
double lowestShoulder(LegId leg, double rotator);

struct JointGain {
  std::uint8_t p;
  std::uint8_t i;
  std::uint8_t d;

  bool operator==(const JointGain& other) const {
    return p == other.p && i == other.i && d == other.d;
  }
};
constexpr JointGain kNeckTiltGain = {0x0A, 0x04, 0x02};
constexpr JointGain kHeadPanGain = {0x08, 0x02, 0x04};
constexpr JointGain kHeadNodGain = {0x08, 0x04, 0x02};
constexpr JointGain kMouthGain = {0x08, 0x00, 0x04};
constexpr JointGain kLegGain = {0x1C, 0x08, 0x01};  // rotator and knee
constexpr JointGain kShoulderGain = {0x14, 0x04, 0x01};
constexpr JointGain kWeakLegGain = {0x10, 0x04,
                                    0x01};  // to spare the battery (facts-2005 section 2.5)
constexpr JointGain kWeakShoulderGain = {0x0A, 0x04, 0x01};
constexpr JointGain kTailGain = {0x0A, 0x04, 0x04};
constexpr JointGain kGainShift = {0x0E, 0x02, 0x0F};  // shift exponents of all joints

// How strongly the leg joints are held: weakly, to spare the battery, or else with a share of their
// standard proportional gain.
struct LegGain {
  bool low = false;
  double share = 1.0;

  bool operator==(const LegGain& other) const { return low == other.low && share == other.share; }
  bool operator!=(const LegGain& other) const { return !(*this == other); }
};

// With a share of its proportional gain: whole numbers, and never none, since a joint without gain
// is not held at all.
JointGain withShare(JointGain gain, double share);
// What is commanded of a joint; but for legs its standard gain.
JointGain gainOf(Joint joint, LegGain legs);
// Mean of the leg joints' proportional gain over the standard one: 0.55 where it is low.
double meanOf(LegGain legs);

}  // namespace kelpie::body
