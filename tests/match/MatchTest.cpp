// SPDX-License-Identifier: Apache-2.0
// Whose log it is, among the robots that the world tells of.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <memory>

#include "robot/agent/log/LoggedTypes.h"
#include "robot/core/log/LogTopics.h"
#include "robot/core/log/LogWriter.h"
#include "tools/match/Match.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::match {
namespace {

namespace fs = std::filesystem;

sim::RobotTruth robot(TeamColour team, std::uint8_t player, Pose2 pose) {
  sim::RobotTruth truth;
  truth.team = team;
  truth.player = player;
  truth.pose = pose;
  return truth;
}

class MatchLog : public testing::Test {
 protected:
  MatchLog() {
    std::string pattern = (fs::temp_directory_path() / "kelpieXXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~MatchLog() override { fs::remove_all(folder_); }

  // One frame of a robot's log: a red forward and a blue goalie are on the field.
  std::string logOf(TeamColour team, std::uint8_t player) const {
    const std::string path = (folder_ / "log.mcap").string();
    auto log = std::move(*LogWriter::open(path));
    const auto config = std::make_unique<agent::AgentConfig>();
    config->team = team;
    config->player = player;
    log.write(kConfigTopic, TimeUs{}, *config);
    sim::TruthFrame truth;
    truth.robots.push_back(robot(TeamColour::red, 2, {{100, 200}, Angle::deg(90)}));
    truth.robots.push_back(robot(TeamColour::blue, 1, {{180, 500}, Angle::deg(-90)}));
    truth.ball = {120, 220};
    log.write(sim::kTruthTopic, TimeUs{1000}, truth);
    log.write(kFrameInputTopic, TimeUs{2000}, *std::make_unique<FrameInput>());
    log.write(kFrameOutputTopic, TimeUs{2000}, *std::make_unique<FrameOutput>());
    EXPECT_TRUE(log.close());
    return path;
  }
  TruePlaces placesIn(const std::string& path) const {
    const auto match = Match::open(path);
    EXPECT_TRUE(match);
    TruePlaces places;
    match->forEachMoment([&](const Moment& moment) {
      places = moment.truth;
      return true;
    });
    return places;
  }

  fs::path folder_;
};

TEST_F(MatchLog, TheOwnRobotIsTheOneWhoseTeamAndPlayerTheConfigurationNames) {
  const TruePlaces places = placesIn(logOf(TeamColour::blue, 1));
  ASSERT_EQ(places.robots.size(), 2U);
  ASSERT_NE(places.own(), nullptr);
  EXPECT_EQ(places.own()->team, TeamColour::blue);
  EXPECT_FALSE(places.robots[0].own);
}

TEST_F(MatchLog, AllPlacesAreInTheFieldFrameOfTheOwnTeam) {
  const TruePlaces blue = placesIn(logOf(TeamColour::blue, 1));
  EXPECT_EQ(blue.own()->pose.position.x, 180.0);
  EXPECT_EQ(blue.own()->pose.position.y, 40.0);
  EXPECT_NEAR(blue.own()->pose.heading.deg(), 90.0, 1e-9);
  EXPECT_EQ(blue.robots[0].pose.position.x, 260.0);
  EXPECT_EQ(blue.ball.y, 320.0);
  const TruePlaces red = placesIn(logOf(TeamColour::red, 2));
  EXPECT_EQ(red.own()->pose.position.x, 100.0);
  EXPECT_EQ(red.robots[1].pose.position.y, 500.0);
}

TEST_F(MatchLog, ARobotThatTheWorldDoesNotKnowHasNoPlace) {
  const TruePlaces places = placesIn(logOf(TeamColour::red, 4));
  EXPECT_TRUE(places.present);
  EXPECT_EQ(places.own(), nullptr);
  EXPECT_EQ(places.robots.size(), 2U);
}

// The pixels of a picture that differ from another one, about a place of the field.
int changed(const cv::Mat& a, const cv::Mat& b, cv::Point middle) {
  int count = 0;
  for (int y = middle.y - 15; y < middle.y + 15; ++y)
    for (int x = middle.x - 15; x < middle.x + 15; ++x)
      count += a.at<cv::Vec3b>(y, x) != b.at<cv::Vec3b>(y, x) ? 1 : 0;
  return count;
}

TEST_F(MatchLog, EveryRobotIsDrawnWhereItIs) {
  const auto match = Match::open(logOf(TeamColour::red, 2));
  ASSERT_TRUE(match);
  const cv::Mat ground = drawField(match->field(), match->team(), 1.0);
  match->forEachMoment([&](const Moment& moment) {
    cv::Mat picture = ground.clone();
    drawPlaces(picture, match->field(), 1.0, moment);
    for (const TrueRobot& truth : moment.truth.robots) {
      const Point2<Field> middle = fieldFromRobot(truth.pose, Point2<Robot>{0.0, -10.0});
      EXPECT_GT(changed(ground, picture, onPicture(match->field(), 1.0, middle)), 40);
    }
    return true;
  });
}

}  // namespace
}  // namespace kelpie::match
