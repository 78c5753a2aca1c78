// SPDX-License-Identifier: Apache-2.0
#include "tests/openr/ContractPage.h"

#include <sstream>

#include "robot/agent/joints/Senses.h"
#include "robot/openr/Contract.h"

namespace kelpie::openr {
namespace {

constexpr const char* kHeading = R"(# What the robot tells and takes

Reference, for who writes code that speaks to a robot: every joint, sensor and light of a real
ERS-7 in its own signs and units, each with the public source that says so. The world, the stand-in
for the robot and the agent must agree on them, and none of them may be its own proof:
`tests/openr/ContractTest.cpp` writes this page from `robot/openr/Contract.h`,
`tests/openr/RawPosesTest.cpp` shows the agent robots that are put together from it by hand, and
`tests/sim/PublishedPosesTest.cpp` lays a physical robot down by the angles that Sony published.
`docs/sources.md` says what each source is. Left and right are the robot's own. A sign in which
Kelpie counts the other way is turned in `robot/agent/joints/Senses.h` and nowhere else.

)";

constexpr const char* kJointsHeading = R"(## Joints

Raw values are microradians. Range and standing in degrees, in the robot's sign; standing is a
robot at the end of the 2005 team's getupf.pos, its head ahead. The last but one column says
whether Kelpie counts the other way.

| joint | locator | positive | range | standing | Kelpie | source |
|---|---|---|---|---|---|---|
)";

constexpr const char* kJointNotes = R"(
What decides where sources differ:

- **J1.** Sony's list of single joints words the range as one of left and right legs (openr.md
  5.6), and Urbi's ERS-7 page repeats it; Tekkotsu's mechanical limits have one range for all
  four. Sony's sample MovingLegs7 sends +120 to both front and -120 to both hind legs, which only
  front against hind allows, as in JointLimit.h and in Tekkotsu's software limits. In its sleeping
  pose (hind J1 -119, J3 122) the thigh of a dog that lies points forward: positive is backward.
- **Tail tilt.** IndicatorsDef.h calls 57 deg up and 1 deg down; Tekkotsu's header says that a
  positive angle lowers the tail itself. Kelpie sends the robot's own number and nothing depends
  on it: look at a robot.
- **Mouth.** It is open at -55; the 2005 team sent -54.4 (-950 000 urad), and -0.6 to close it,
  which the software limit makes -3.

)";

constexpr const char* kSensorsHeading = R"(## Sensors

A vector has them in no documented order; each is found by its locator. Joints are sensors too,
under the locators above, with motor duty from -512 to 512 in the joint's sign.

| sensor | locator | unit | value | range | standing | source |
|---|---|---|---|---|---|---|
)";

constexpr const char* kSensorNotes = R"(
The axes point backward, left and down, and what is measured is the push that holds the robot up: on
its nose backward, on its right side to the left, on its feet upward, so -g in a3. A trunk that
stands level has none in a1; with its nose down it is positive.

)";

constexpr const char* kLightsHeading = R"(## Lights and ears

LED2 are on or off, LED3 have an intensity of 0 to 255 and a mode: A for the face, undefined
(0xffff) for the back, which has no modes (Sony's sample BlinkingLED7; the 2005 team's
Indicators.cc). Places and colours are those of ERS7Info.h, LedEngine.h and Indicators.h; that of
the face's middle is Face.cc's, which has a light go from side to side by 3, 5, 12, 6 and 4. No
source at hand tells where 9, 10 and 11 are.

| bit | locator | place |
|---|---|---|
)";

constexpr const char* kImageText = R"(## Camera

)";

constexpr const char* kImageNotes = R"(
30 images in a second, layer H 208 x 160. A line is 208 bytes of Y, then 208 of Cr, then 208 of
Cb; in an image with high-pass parts (type 24) three more rows of 208 follow. Bands are numbered Y
0, Cr 1, Cb 2 (OFbkImage.h; measured in openr.md 5.3). The last line of a layer is a tag in place
of pixels. An orange ball has more Cr than Cb: (140, 181, 79) (facts-2005 section 3).

)";

constexpr const char* kPowerHeading = R"(## Power

Bits of OPowerStatus with the numbers of Sony's OPower.h. The current is negative while the
battery gives it (ERS7Info.h).

| word | bit | name | meaning |
|---|---|---|---|
)";

std::string degrees(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string hex(longword value) {
  std::ostringstream text;
  text << "0x" << std::hex << value;
  return text.str();
}

std::string cells(std::initializer_list<std::string> texts) {
  std::string row = "|";
  for (const std::string& text : texts) row += " " + text + " |";
  return row + "\n";
}

std::string joints() {
  std::string text = kJointsHeading;
  for (std::size_t i = 0; i < kJointRows.size(); ++i) {
    const JointRow& row = kJointRows[i];
    const bool turned = agent::robotSenses().joints[i] < 0.0;
    text +=
        cells({row.name, row.locator, row.positive, degrees(row.min) + " to " + degrees(row.max),
               degrees(row.standing), turned ? "turned" : "same", row.source});
  }
  return text + kJointNotes;
}

std::string range(const SensorRow& row) {
  const std::string from = std::to_string(row.min);
  return row.max == kOpenEnded ? from + " and up" : from + " to " + std::to_string(row.max);
}

std::string sensors() {
  std::string text = kSensorsHeading;
  for (const SensorRow& row : kSensorRows) {
    text +=
        cells({row.name, row.locator, row.unit, row.meaning, range(row), row.standing, row.source});
  }
  return text + kSensorNotes;
}

std::string lights() {
  std::string text = kLightsHeading;
  for (std::size_t i = 0; i < kLightRows.size(); ++i)
    text += cells({std::to_string(i), kLightRows[i].locator, kLightRows[i].place});
  text += "\nEars, state 1 is up (IndicatorsDef.h, Indicators.cc): left `" +
          std::string(kEarRows[0]) + "`,\nright `" + kEarRows[1] + "`.\n\n";
  return text;
}

std::string power() {
  std::string text = kPowerHeading;
  for (const PowerRow& row : kPowerRows)
    text +=
        cells({row.battery ? "batteryStatus" : "robotStatus", hex(row.bit), row.name, row.meaning});
  return text;
}

}  // namespace

std::string contractPage() {
  return kHeading + joints() + sensors() + lights() + kImageText + "`" + kCameraRow + "`\n" +
         kImageNotes + power();
}

}  // namespace kelpie::openr
