// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "robot/body/Camera.h"
#include "robot/core/fields/Schema.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/FrameOutput.h"

namespace kelpie {
namespace {

TEST(Schema, NamesTheFolderAndTheType) {
  EXPECT_EQ(schemaName<FrameInput>(), "kelpie/FrameInput");
  EXPECT_EQ(schemaName<body::BodyParams>(), "kelpie_body/BodyParams");
  EXPECT_EQ(schemaName<Point2<Robot>>(), "kelpie/Point2");
}

TEST(Schema, TextHasUnitsRangesAndNestedTypesOnce) {
  const std::string rule(80, '=');
  EXPECT_EQ(schemaText<BallEstimate>(),
            "bool present\n"
            "kelpie/Point2 position\n"
            "kelpie/Point2 velocity\n"
            "float64[4] covariance  # cm2\n"
            "kelpie/Point2 relative\n"
            "float64 distance  # cm, 0..1500\n"
            "float64 heading  # rad, -180..180 deg\n"
            "float64 secondsSinceSeen  # s, 0..1e+06\n"
            "float64[4] fieldCovariance  # cm2\n"
            "kelpie/Point2 stoppingPoint\n" +
                rule + "\nMSG: kelpie/Point2\nfloat64 x  # cm\nfloat64 y  # cm\n");
}

TEST(Schema, VectorsHaveNoLengthAndEnumsAreNumbers) {
  const std::string text = schemaText<Percepts>();
  EXPECT_NE(text.find("kelpie/LandmarkPercept[] landmarks\n"), std::string::npos);
  EXPECT_NE(text.find("uint8 kind  # 0..5\n"), std::string::npos);
  EXPECT_NE(text.find("uint16[96] refused\n"), std::string::npos);
}

TEST(Schema, EveryLineIsAFieldAHeadingOrARule) {
  const std::regex good(
      "[a-z0-9]+(/[A-Za-z0-9]+)?(\\[[0-9]*\\])? [a-z][a-zA-Z0-9_]*(  # .+)?|MSG: kelpie/\\w+|=+");
  for (const std::string& text : {schemaText<FrameInput>(), schemaText<FrameOutput>(),
                                  schemaText<MotionInput>(), schemaText<MotionOutput>()}) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_TRUE(std::regex_match(line, good)) << line;
    }
  }
}

}  // namespace
}  // namespace kelpie
