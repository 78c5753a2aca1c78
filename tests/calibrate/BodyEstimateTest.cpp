// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "StandMaker.h"
#include "tools/calibrate/body/BodyEstimate.h"

namespace kelpie::calibrate {
namespace {

Stand randomised() {
  Stand stand;
  stand.body.lens.focalLength = 199.0;
  stand.body.neckTiltOffset = Angle::deg(-2.4);
  stand.body.headNodOffset = Angle::deg(-0.5);
  stand.body.bodyRollOffset = Angle::deg(1.3);
  stand.panPlay = Angle::deg(2.0).rad();
  return stand;
}

double found(const BodyEstimate& e, Unknown unknown) { return e.unknowns[unknown].value; }

TEST(BodyEstimate, FindsLensNeckRollAndPlayOfARandomisedRobot) {
  const auto e = estimateBody(logOf(randomised()));
  ASSERT_TRUE(e.ok()) << e.error();
  EXPECT_NEAR(e->params.lens.focalLength, 199.0, 0.005 * 199.0);
  EXPECT_NEAR(e->params.neckTiltOffset.deg(), -2.4, 0.15);
  EXPECT_NEAR(e->params.headNodOffset.deg(), -0.5, 0.2);
  EXPECT_NEAR(e->params.bodyRollOffset.deg(), 1.3, 0.2);
  EXPECT_NEAR(found(*e, kPanPlay), 2.0, 0.3);
  EXPECT_NEAR(found(*e, kPlaceX), 120.0, 1.5);
  EXPECT_NEAR(found(*e, kPlaceY), 200.0, 1.5);
}

TEST(BodyEstimate, AnOrdinaryRobotKeepsItsParameters) {
  const auto e = estimateBody(logOf({}));
  ASSERT_TRUE(e.ok()) << e.error();
  EXPECT_NEAR(e->params.lens.focalLength, 192.0, 0.005 * 192.0);
  EXPECT_NEAR(e->params.neckTiltOffset.deg(), 0.0, 0.15);
}

TEST(BodyEstimate, ResidualsShrink) {
  const auto e = estimateBody(logOf(randomised()));
  ASSERT_TRUE(e.ok()) << e.error();
  for (const auto kind : {SightKind::bandBorder, SightKind::linePoint, SightKind::carpetEnd})
    EXPECT_LT(medianMiss(e->after, kind), 0.4 * medianMiss(e->before, kind)) << nameOf(kind);
}

TEST(BodyEstimate, WhatTheAgentBelievedOfItsTiltDoesNotMatter) {
  StandingLog log = logOf(randomised());
  const auto plain = estimateBody(log);
  for (StandingFrame& frame : log.frames) frame.input.cameraTilt.tilt = Angle::deg(5.0);
  const auto believed = estimateBody(log);
  ASSERT_TRUE(plain.ok() && believed.ok());
  EXPECT_EQ(plain->params.neckTiltOffset.rad(), believed->params.neckTiltOffset.rad());
}

TEST(BodyEstimate, WithoutLandmarksItRefusesInOneLine) {
  Stand bare;
  bare.ways = 1;
  bare.landmarks = false;
  const auto e = estimateBody(logOf(bare));
  ASSERT_FALSE(e.ok());
  EXPECT_NE(e.error().find("too few landmarks: 0"), std::string::npos) << e.error();
  EXPECT_EQ(e.error().find('\n'), std::string::npos);
}

TEST(BodyEstimate, AFieldWithOtherLinesIsRefused) {
  StandingLog log = logOf({});
  for (body::FieldLine& line : log.config->field.lines) {
    line.start.x += 25.0;
    line.end.x += 25.0;
    line.start.y += 25.0;
    line.end.y += 25.0;
  }
  const auto e = estimateBody(log);
  ASSERT_FALSE(e.ok());
  EXPECT_NE(e.error().find("are on no line"), std::string::npos) << e.error();
}

TEST(BodyEstimate, ARobotThatWasPushedIsRefused) {
  StandingLog log = logOf({});
  Stand pushed;
  pushed.place.position = {135.0, 200.0};
  StandingLog later = logOf(pushed);
  for (std::size_t i = log.frames.size() / 2; i < log.frames.size(); ++i)
    log.frames[i].input.image = later.frames[i].input.image;
  const auto e = estimateBody(log);
  ASSERT_FALSE(e.ok());
  EXPECT_NE(e.error().find("was moved"), std::string::npos) << e.error();
}

// One way from side to side with one neck angle: a share of that angle is an offset.
TEST(BodyEstimate, WhatOneNeckAngleCannotTellIsLeftAndSaid) {
  Stand once = randomised();
  once.ways = 1;
  const auto e = estimateBody(logOf(once));
  ASSERT_TRUE(e.ok()) << e.error();
  EXPECT_FALSE(e->unknowns[kNeckGives].observed);
  EXPECT_EQ(e->params.neckGives, 0.0);
  EXPECT_TRUE(e->unknowns[kNeckTilt].observed);
}

TEST(PanSlack, FollowsTheEndsOfTheDeadZoneAndNotTheNoise) {
  const double noise = 0.004;
  const std::vector<double> pans = {0.0, 0.5, 0.5 + noise, 0.5 - noise, 1.0, 0.5, 0.5 + noise};
  const auto slack = panSlack(pans, 0.06);
  EXPECT_DOUBLE_EQ(slack[1], -0.03);
  EXPECT_DOUBLE_EQ(slack[2], -0.03);
  EXPECT_DOUBLE_EQ(slack[4], -0.03);
  EXPECT_DOUBLE_EQ(slack[5], 0.03);
  EXPECT_DOUBLE_EQ(slack[6], 0.03);
}

}  // namespace
}  // namespace kelpie::calibrate
