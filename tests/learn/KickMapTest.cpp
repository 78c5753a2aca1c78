// SPDX-License-Identifier: Apache-2.0
// The map of kicks: learnt on tiny grids, summed up from made runs, written and read again.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "tools/learn/kick/KickMapFile.h"
#include "tools/learn/walk/WalkLearner.h"

namespace kelpie::learn {
namespace {

constexpr double kStep = 0.002;

KickMapPlan tinyPlan() {
  KickMapPlan plan;
  plan.trials = 2;
  plan.lateral = 4.0;
  plan.nearest = plan.furthest = 14.0;
  plan.step = 4.0;
  return plan;
}

bool goOn(std::size_t, std::size_t) { return true; }

KickRun runOf(double distance, double degrees, bool fell = false) {
  return {{distance, Angle::deg(degrees), fell, true, {}}, true};
}

KickCell goes(double share, double degrees, double distance) {
  KickCell cell;
  cell.runs = 10;
  cell.went = share;
  cell.direction = Angle::deg(degrees);
  cell.directionSd = Angle::deg(3.0);
  cell.distance = distance;
  cell.distanceSd = 10.0;
  return cell;
}

// Three by two places of a kick to the left.
KickGrid smallGrid() {
  KickGrid grid;
  grid.motion = MotionKind::upennLeft;
  grid.lateral = {2.0, 4.0, 6.0};
  grid.ahead = {12.0, 14.0};
  grid.cells = {goes(1.0, 50.0, 200.0), goes(1.0, 40.0, 200.0), goes(0.5, 30.0, 100.0),
                goes(1.0, 45.0, 200.0), goes(0.9, 41.0, 220.0), KickCell{}};
  return grid;
}

std::string standardText() {
  std::ifstream file(std::string(KELPIE_SOURCE_DIR) + "/pycode/data/kick_map.py");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(KickMap, LearntTwiceIsTheSameAndOfAnotherSeedAnother) {
  KickMapPlan plan = tinyPlan();
  const std::string one = kickMapText(learnKickMap(plan, goOn), "a");
  EXPECT_EQ(one, kickMapText(learnKickMap(plan, goOn), "a"));
  plan.seed = 2;
  EXPECT_NE(one, kickMapText(learnKickMap(plan, goOn), "a"));
}

TEST(KickMap, SaysThatASwipeToTheLeftGoesLeftAndAHeldKickAhead) {
  KickMapPlan plan = tinyPlan();
  plan.step = 2.0;
  plan.trials = 3;
  const KickMap map = learnKickMap(plan, goOn);
  int checked = 0;
  for (const KickGrid& grid : map) {
    const KickCell& whole = grid.window.whole;
    if (grid.motion == MotionKind::headSwipeLeft) {
      EXPECT_GT(whole.direction.deg(), 10.0);
    } else if (grid.from == KickFrom::hold && grid.motion != MotionKind::upennLeft) {
      EXPECT_NEAR(whole.direction.deg(), 0.0, 5.0);
    } else {
      continue;
    }
    EXPECT_GT(whole.went, 0.6);
    ++checked;
  }
  EXPECT_EQ(checked, 5);
}

TEST(KickMap, KickIntoNothingHasNoSuccess) {
  const auto start = standingStart(variedModels(31, 1, kStep).front(), 31);
  std::vector<KickRun> runs;
  for (const MotionKind kick : {MotionKind::kickForward, MotionKind::upennLeft})
    runs.push_back(kickFrom({0.0, 45.0}, kick, start));
  const KickCell cell = cellOf(runs);
  EXPECT_EQ(cell.runs, 2);
  EXPECT_EQ(cell.went, 0.0);
  EXPECT_EQ(cell.fell, 0.0);
}

TEST(KickMap, BallInsideTheRobotDoesNotCount) {
  const auto start = standingStart(variedModels(31, 1, kStep).front(), 31);
  EXPECT_FALSE(kickFrom({0.0, -5.0}, MotionKind::kickForward, start).counts);
  EXPECT_EQ(cellOf({kickFrom({0.0, -5.0}, MotionKind::kickForward, start)}).runs, 0);
}

TEST(KickMap, IsEmptyWhenItWasInterrupted) {
  for (const int after : {3, 20}) {
    int reported = 0;
    const auto stop = [&](std::size_t, std::size_t) { return ++reported < after; };
    EXPECT_TRUE(learnKickMap(tinyPlan(), stop).empty());
    EXPECT_LT(reported, after + 20);
  }
}

TEST(KickMap, WalkingRobotHasTheBallWhereItShallBeAsTheMotionBegins) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const WalkRequest walk = drawLastSteps(random).walk;
    const Point2<Robot> place{random.uniform(-8.0, 8.0), random.uniform(10.0, 18.0)};
    const Point2<Robot> asked = placeAsAsked(place, walk);
    EXPECT_GT(asked.y, place.y + 0.3);  // it walks on towards it
    EXPECT_NEAR((placeAtKick(asked, walk) - place).norm(), 0.0, 1e-9);
  }
}

TEST(KickCell, HasTheDirectionAndDistanceOfTheBallsThatWent) {
  const KickCell cell = cellOf(
      {runOf(100.0, 170.0), runOf(200.0, -170.0), runOf(5.0, 40.0), runOf(150.0, 180.0, true)});
  EXPECT_EQ(cell.runs, 4);
  EXPECT_NEAR(cell.went, 0.75, 1e-9);
  EXPECT_NEAR(cell.fell, 0.25, 1e-9);
  EXPECT_NEAR(std::fabs(cell.direction.deg()), 180.0, 1e-6);
  EXPECT_NEAR(cell.directionSd.deg(), std::sqrt(200.0 / 3.0), 1e-6);
  EXPECT_NEAR(cell.distance, 150.0, 1e-9);
  EXPECT_NEAR(cell.distanceSd, std::sqrt(5000.0 / 3.0), 1e-6);
}

TEST(KickCell, BetweenPlacesCountsEachByTheBallsThatWent) {
  const KickGrid grid = smallGrid();
  EXPECT_NEAR(cellAt(grid, {3.0, 12.0}).direction.deg(), 45.0, 1e-9);
  const KickCell between = cellAt(grid, {5.0, 12.0});
  EXPECT_NEAR(between.went, 0.75, 1e-9);
  EXPECT_NEAR(between.direction.deg(), (40.0 + 0.5 * 30.0) / 1.5, 1e-9);
  EXPECT_NEAR(between.distance, 250.0 / 1.5, 1e-9);
}

TEST(KickCell, OutsideTheGridAndBesideAPlaceWithoutRunsHasNone) {
  const KickGrid grid = smallGrid();
  for (const Point2<Robot> place : {Point2<Robot>{1.9, 12.0}, Point2<Robot>{3.0, 14.1},
                                    Point2<Robot>{5.0, 13.0}, Point2<Robot>{6.0, 14.0}})
    EXPECT_EQ(cellAt(grid, place).runs, 0);
  EXPECT_GT(cellAt(grid, {6.0, 12.0}).runs, 0);
}

TEST(KickCell, OfAKickThatIsItsOwnMirrorImageIsMirrored) {
  KickGrid grid = smallGrid();
  grid.motion = MotionKind::kickForward;
  EXPECT_NEAR(cellAt(grid, {-3.0, 12.0}).direction.deg(), -45.0, 1e-9);
}

TEST(KickWindow, HoldsThePlacesThatAreAlikeAndSure) {
  const KickWindow window = windowOf(smallGrid());
  EXPECT_EQ(window.min.x, 2.0);
  EXPECT_EQ(window.max.x, 4.0);
  EXPECT_EQ(window.min.y, 12.0);
  EXPECT_EQ(window.max.y, 14.0);
  EXPECT_NEAR(window.whole.direction.deg(), 44.0, 1e-6);
  EXPECT_NEAR(window.whole.went, 0.975, 1e-9);
  EXPECT_GT(window.whole.directionSd.deg(), 3.0);  // of each place, and between them
}

TEST(KickWindow, OfNothingSureIsOnePlace) {
  KickGrid grid = smallGrid();
  for (KickCell& cell : grid.cells) cell.went *= 0.5;
  const KickWindow window = windowOf(grid);
  EXPECT_EQ(window.min.x, window.max.x);
  EXPECT_EQ(window.min.y, window.max.y);
}

TEST(KickMapFile, IsReadAsItWasWritten) {
  KickGrid grid = smallGrid();
  grid.window = windowOf(grid);
  grid.frames = 6;
  grid.way = {5.5, 3.5, Angle::deg(36.0), 0.0, 0.0, {}};
  const auto map = readKickMap(kickMapText({grid}, "how"));
  ASSERT_TRUE(map.ok()) << map.error();
  ASSERT_EQ(map->size(), 1U);
  const KickGrid& read = map->front();
  EXPECT_EQ(read.motion, grid.motion);
  EXPECT_EQ(read.lateral, grid.lateral);
  EXPECT_EQ(read.window.best.x, grid.window.best.x);
  EXPECT_NEAR(read.way.turn.deg(), 36.0, 1e-9);
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    EXPECT_EQ(read.cells[i].runs > 0, grid.cells[i].runs > 0);
    EXPECT_NEAR(read.cells[i].went, grid.cells[i].went, 1e-9);
    EXPECT_NEAR(read.cells[i].direction.deg(), grid.cells[i].direction.deg(), 1e-9);
  }
}

TEST(KickMapFile, TheStandardOneReadsAndHasEveryLeftKick) {
  const auto map = readKickMap(standardText());
  ASSERT_TRUE(map.ok()) << map.error();
  EXPECT_EQ(map->size(), 10U);
  for (const KickGrid& grid : *map) EXPECT_GE(grid.window.whole.went, 0.8);
}

TEST(KickMapFile, ThatIsCutOffIsRefused) {
  const std::string text = standardText();
  for (const std::size_t length : {text.size() / 4, text.size() / 2, text.size() - 20})
    EXPECT_FALSE(readKickMap(text.substr(0, length)).ok()) << length;
  EXPECT_FALSE(readKickMap("").ok());
}

}  // namespace
}  // namespace kelpie::learn
