// SPDX-License-Identifier: Apache-2.0
// What a made match of a few seconds was worth: frames of 1/30 s, a model that says the same of
// every moment or looks at the distance to the goal alone.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "robot/core/log/LogWriter.h"
#include "tools/league/value/MatchValue.h"
#include "tools/league/value/Report.h"
#include "tools/league/value/Rows.h"

namespace kelpie::value {
namespace {

const body::FieldDescription kField = *body::fieldDescription("2006");
constexpr std::size_t kGoal = 0;  // the first of the features

// Probability 0.2 within 10 s, whatever there is.
Models level() { return {{10.0, maths::log(0.25), {}}, {10.0, maths::log(0.25), {}}}; }
// The nearer to the goal the more.
Models byDistance() {
  const Model model{10.0, 0.0, {{kGoal, {0.0, 540.0}, {2.0, -4.0}}}};
  return {model, model};
}

sim::MatchEvent event(double seconds, sim::EventKind kind, TeamColour team = TeamColour::red) {
  sim::MatchEvent made;
  made.time = TimeUs{static_cast<std::int64_t>(1e6 * seconds)};
  made.kind = kind;
  made.team = team;
  return made;
}

// From the whistle at 1 s to a goal of red at 11 s; then nobody plays for 5 s. Red's number 3
// stands behind a ball in midfield and kicks it at 6 s straight up the field.
PlayedTruth oneGoal() {
  PlayedTruth match;
  match.events = {event(0.0, sim::EventKind::start), event(1.0, sim::EventKind::play),
                  event(11.0, sim::EventKind::goal), event(11.0, sim::EventKind::ready)};
  for (int i = 1; i <= 480; ++i) {
    sim::TruthFrame truth;
    truth.time = TimeUs{i * 1000000LL / 30};
    const double rolled = std::max(0.0, truth.time.seconds() - 6.0);
    truth.ball = {180.0, std::min(580.0, 270.0 + 100.0 * rolled)};
    if (rolled > 0.0) truth.ballVelocity = {0.0, 250.0};
    truth.robots.push_back({TeamColour::red, 3, {{180.0, 255.0}, Angle::deg(90.0)}, {}});
    truth.robots.push_back({TeamColour::blue, 2, {{20.0, 20.0}, Angle::deg(90.0)}, {}});
    match.frames.push_back(truth);
  }
  return match;
}

TEST(PlayedTruth, IsInPlayFromTheWhistleToTheGoalAlone) {
  const std::vector<Stretch> stretches = stretchesOf(oneGoal());
  ASSERT_EQ(stretches.size(), 1U);
  EXPECT_DOUBLE_EQ(stretches[0].begin, 1.0);
  EXPECT_DOUBLE_EQ(stretches[0].end, 11.0);
  EXPECT_EQ(stretches[0].goal, TeamColour::red);
}

TEST(PlayedTruth, ABallThatIsTakenAwayIsNotInPlayUntilItIsBack) {
  PlayedTruth match = oneGoal();
  match.events.insert(match.events.begin() + 2,
                      {event(3.0, sim::EventKind::taken), event(5.0, sim::EventKind::returned)});
  const std::vector<Stretch> stretches = stretchesOf(match);
  ASSERT_EQ(stretches.size(), 2U);
  EXPECT_FALSE(stretches[0].goal);
  EXPECT_DOUBLE_EQ(stretches[0].end, 3.0);
  EXPECT_DOUBLE_EQ(stretches[1].begin, 5.0);
}

TEST(PlayedTruth, AMatchWithoutTheRulesIsInPlayFromItsStartAndAfterAGoal) {
  PlayedTruth match = oneGoal();
  match.events = {event(0.0, sim::EventKind::start), event(11.0, sim::EventKind::goal)};
  EXPECT_EQ(stretchesOf(match).size(), 2U);
}

TEST(PlayedTruth, AFileWithoutTruthGivesOneLine) {
  const std::string path = testing::TempDir() + "no_truth.mcap";
  std::ofstream(path) << "nothing";
  const auto read = readTruth(path);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().find('\n'), std::string::npos);
}

TEST(Rows, TellHowTheStretchEndedForEachTeam) {
  const std::vector<Row> rows = rowsOf(oneGoal(), kField, 0.5);
  ASSERT_EQ(rows.size(), 40U);  // 20 moments, two teams
  EXPECT_EQ(rows[0].ends, 1);
  EXPECT_EQ(rows[1].ends, -1);
  EXPECT_NEAR(rows[0].left, 10.0, 1e-6);
}

TEST(MatchValue, ALevelValueAddsUpToItsRate) {
  const MatchFigures figures = figuresOf(oneGoal(), level(), kField);
  EXPECT_NEAR(figures.played, 10.0, 1e-6);
  EXPECT_NEAR(figures.of(TeamColour::red).value, 0.2, 1e-6);  // 0.2 in 10 s
  EXPECT_NEAR(figures.value(), 0.0, 1e-9);
  EXPECT_EQ(figures.of(TeamColour::red).goals, 1);
  EXPECT_EQ(figures.of(TeamColour::blue).goals, 0);
}

TEST(MatchValue, WhoScoresEarlyInASceneDoesNotLoseByItsEnd) {
  const MatchFigures figures = figuresOf(oneGoal(), byDistance(), kField);
  EXPECT_NEAR(sceneValue(figures, 40.0, 10.0), figures.value(), 1e-9);
  EXPECT_NEAR(sceneValue(figures, 40.0, 15.0), figures.value() + 5.0 / 40.0, 1e-9);
  EXPECT_NEAR(sceneValue(figuresOf(PlayedTruth{}, byDistance(), kField), 40.0, 15.0), 0.0, 1e-9);
}

TEST(MatchValue, AKickAtTheGoalIsAShotAndGains) {
  const MatchFigures figures = figuresOf(oneGoal(), byDistance(), kField);
  ASSERT_EQ(figures.kicks.size(), 1U);
  EXPECT_EQ(figures.kicks[0].player, 3);
  EXPECT_TRUE(figures.kicks[0].shot);
  EXPECT_GT(figures.kicks[0].gained, 0.0);
  EXPECT_EQ(figures.of(TeamColour::red).shots, 1);
  EXPECT_GT(figures.of(TeamColour::red).shotGoals, 0.0);
  EXPECT_GT(figures.value(), 0.0);
}

TEST(MatchValue, DoingsAddUpToWhatTheStretchBrought) {
  const PlayedTruth match = oneGoal();
  const MatchFigures figures = figuresOf(match, byDistance(), kField);
  double gained = 0.0;
  for (const Doing& doing : figures.doings) {
    EXPECT_EQ(doing.player, 3);
    gained += doing.gained;
  }
  const TeamValues first = valuesOf(byDistance().near, match.frames[29], kField);
  EXPECT_NEAR(gained, 1.0 - (first[0] - first[1]), 1e-9);  // it ends in a goal
}

TEST(MatchValue, TheTurnedMatchIsTheOtherTeams) {
  PlayedTruth match = oneGoal();
  for (sim::TruthFrame& truth : match.frames) {
    truth.ball = {kField.width - truth.ball.x, kField.length - truth.ball.y};
    truth.ballVelocity = truth.ballVelocity * -1.0;
    for (sim::RobotTruth& robot : truth.robots) {
      robot.team = robot.team == TeamColour::red ? TeamColour::blue : TeamColour::red;
      robot.pose.position = {kField.width - robot.pose.position.x,
                             kField.length - robot.pose.position.y};
      robot.pose.heading = robot.pose.heading + Angle::deg(180.0);
    }
  }
  for (sim::MatchEvent& each : match.events) each.team = TeamColour::blue;
  const MatchFigures here = figuresOf(oneGoal(), byDistance(), kField);
  const MatchFigures there = figuresOf(match, byDistance(), kField);
  EXPECT_NEAR(here.value(), -there.value(), 1e-9);
  EXPECT_EQ(there.of(TeamColour::blue).shots, 1);
}

TEST(Report, TellsGoalsShotsExpectedGoalsAndWhoseDoing) {
  Report report;
  report.add(figuresOf(oneGoal(), byDistance(), kField), Leaves());
  const std::string text = report.text();
  for (const char* word : {"goals", "shots", "expected", "against", "value by robot"})
    EXPECT_NE(text.find(word), std::string::npos) << word;
  EXPECT_EQ(text.find("value by leaf"), std::string::npos);  // no robot's log was given
}

TEST(Report, AsJsonHasTheValueAsRedSeesIt) {
  const MatchFigures figures = figuresOf(oneGoal(), byDistance(), kField);
  const cli::Json json = jsonOf(figures);
  EXPECT_DOUBLE_EQ(json.at("value").get<double>(), figures.value());
  for (const char* key : {"red_value", "blue_value", "red_shots", "blue_xg"})
    EXPECT_TRUE(json.contains(key)) << key;
}

}  // namespace
}  // namespace kelpie::value
