// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>

#include "tests/behaviour/Scripts.h"
#include "tools/match/SkillField.h"

namespace kelpie::match {
namespace {

class SkillField : public testing::Test {
 protected:
  Expected<std::vector<SkillStep>> steps(const std::string& body) {
    const behaviour::Scripts scripts(body);
    behaviour::BehaviourState behaviours(scripts.path());
    config->behaviour.task.player = PlayerKind::skill;
    config->behaviour.task.skill = 3;
    return skillField(*config, question, behaviours);
  }

  std::unique_ptr<agent::AgentConfig> config = std::make_unique<agent::AgentConfig>();
  SkillQuestion question{{180, 270}, std::nullopt, 60.0};
};

TEST_F(SkillField, HasAStepForEachPlaceOfTheGrid) {
  const auto field = steps("return kelpie.Command()");
  ASSERT_TRUE(field) << field.error();
  ASSERT_EQ(field->size(), 6U * 9U);
  EXPECT_EQ(field->front().place.x, 30.0);
  EXPECT_EQ(field->back().place.y, 510.0);
}

TEST_F(SkillField, ARobotThatFacesTheBallWalksToItFromEverywhere) {
  const auto field = steps(
      "seen = world.percepts.ball.present and abs(world.ball.heading_deg) < 0.01\n"
      "    return kelpie.Command(walk=kelpie.WalkRequest(forward=20.0 if seen else 0.0))");
  ASSERT_TRUE(field) << field.error();
  for (const SkillStep& step : *field) {
    const double x = question.ball.x - step.place.x;
    const double y = question.ball.y - step.place.y;
    EXPECT_NEAR(step.way.x * y, step.way.y * x, 1e-6);
    EXPECT_GT(step.way.x * x + step.way.y * y, 0.0);
  }
}

TEST_F(SkillField, TheWayIsInTheFieldFrameWhateverTheHeading) {
  question.heading = Angle::deg(180.0);
  const auto field = steps("return kelpie.Command(walk=kelpie.WalkRequest(forward=10, left=2))");
  ASSERT_TRUE(field) << field.error();
  EXPECT_NEAR(field->front().way.x, -10.0, 1e-9);
  EXPECT_NEAR(field->front().way.y, -2.0, 1e-9);
}

TEST_F(SkillField, TheSkillAndTheSightAreShown) {
  question.heading = Angle::deg(90.0);
  const auto field = steps(
      "kinds = [mark.kind for mark in world.percepts.landmarks]\n"
      "    ahead = kelpie.GOAL_BLUE in kinds and len(world.percepts.gaps) == 1\n"
      "    return kelpie.Command(walk=kelpie.WalkRequest(\n"
      "        forward=world.task.skill, left=5 if ahead else 0))");
  ASSERT_TRUE(field) << field.error();
  const SkillStep& behindTheBall = (*field)[3 * 6 + 2];  // at 150, 210
  EXPECT_NEAR(behindTheBall.way.y, 3.0, 1e-9);
  EXPECT_NEAR(behindTheBall.way.x, -5.0, 1e-9) << "the goal is seen";
}

TEST_F(SkillField, BehavioursThatFailAreAnErrorThatNamesThePlace) {
  const auto field = steps("return kelpie.Command() if world.pose.position.x < 40 else None");
  ASSERT_FALSE(field);
  EXPECT_NE(field.error().find("not a kelpie.Command (robot at 90, 30)"), std::string::npos)
      << field.error();
}

}  // namespace
}  // namespace kelpie::match
