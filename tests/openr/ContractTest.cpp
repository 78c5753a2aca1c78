// SPDX-License-Identifier: Apache-2.0
// The rows of the contract against what the agent and the world are made of, and its page.
#include <OPENR/OPower.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "robot/agent/joints/Senses.h"
#include "robot/body/Ers7.h"
#include "robot/openr/Contract.h"
#include "tests/openr/ContractPage.h"

namespace kelpie::openr {
namespace {

TEST(RobotContract, LocatorsAreThoseThatTheAgentOpens) {
  for (std::size_t i = 0; i < kJointCount; ++i)
    EXPECT_STREQ(kJointRows[i].locator, kJointLocators[i]);
  for (std::size_t i = 0; i < kSensorCount; ++i)
    EXPECT_STREQ(kSensorRows[i].locator, kSensorLocators[i]);
  for (std::size_t i = 0; i < kLedCount; ++i) EXPECT_STREQ(kLightRows[i].locator, kLedLocators[i]);
  for (std::size_t i = 0; i < kEarCount; ++i) EXPECT_STREQ(kEarRows[i], kEarLocators[i]);
  EXPECT_STREQ(kCameraRow, kCameraLocator);
}

TEST(RobotContract, RangesTurnedByTheSensesAreKelpies) {
  const agent::Senses senses = agent::robotSenses();
  for (std::size_t i = 0; i < kJointCount; ++i) {
    const JointRow& row = kJointRows[i];
    const bool turned = senses.joints[i] < 0.0;
    EXPECT_EQ(body::kJointRanges[i].min, turned ? -row.max : row.min) << row.name;
    EXPECT_EQ(body::kJointRanges[i].max, turned ? -row.min : row.max) << row.name;
    EXPECT_TRUE(row.standing >= row.min && row.standing <= row.max) << row.name;
  }
}

TEST(RobotContract, SensorsEndWhereTheStandInLetsThemEnd) {
  const auto ends = [](Sensor sensor, const SensorRange& range) {
    const SensorRow& row = kSensorRows[index(sensor)];
    EXPECT_NEAR(row.min * kMicrometre, range.min, 1e-9) << row.name;
    EXPECT_NEAR(row.max * kMicrometre, range.max, 1e-9) << row.name;
  };
  ends(Sensor::headNear, kHeadNearRange);
  ends(Sensor::headFar, kHeadFarRange);
  ends(Sensor::chest, kChestRange);
  ends(Sensor::accelerationBack, kAccelerationRange);
  ends(Sensor::accelerationLeft, kAccelerationRange);
  ends(Sensor::accelerationDown, kAccelerationRange);
}

TEST(RobotContract, PowerBitsHaveTheNumbersOfTheStandInsHeader) {
  constexpr std::array<longword, kPowerRows.size()> kBits = {orsbPAUSE,
                                                             orsbMOTOR_POWER,
                                                             orsbBATTERY_CONNECTED,
                                                             orsbBATTERY_CAPACITY_LOW,
                                                             orsbBATTERY_OVER_CURRENT,
                                                             orsbBATTERY_OVER_TEMP_DISCHARGING,
                                                             orsbERROR_OF_FAN,
                                                             obsbTERMINATED_DISCHARGING_ALARM,
                                                             obsbOVER_TEMP_ALARM};
  for (std::size_t i = 0; i < kBits.size(); ++i)
    EXPECT_EQ(kPowerRows[i].bit, kBits[i]) << kPowerRows[i].name;
}

TEST(RobotContract, ThePageIsWrittenFromTheRows) {
  std::ifstream file(KELPIE_SOURCE_DIR "/docs/robot-contract.md");
  std::ostringstream text;
  text << file.rdbuf();
  if (text.str() == contractPage()) return;
  std::filesystem::create_directories(KELPIE_SOURCE_DIR "/build");
  std::ofstream(KELPIE_SOURCE_DIR "/build/robot-contract.md") << contractPage();
  ADD_FAILURE() << "docs/robot-contract.md is not what robot/openr/Contract.h says; rewrite it by\n"
                   "  cp build/robot-contract.md docs/";
}

}  // namespace
}  // namespace kelpie::openr
