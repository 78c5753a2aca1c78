// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "robot/body/Camera.h"
#include "tests/vision/Board.h"
#include "vision/goal/GoalPlace.h"

namespace kelpie::vision {
namespace {

// The robot stands at a place of the 2006 field and looks along `heading`, x to the right of the
// way to the blue goal.
struct View {
  Pose2 pose;
  Board board;

  explicit View(const Pose2& at) : pose(at), board(cameraAt(16, 0, -8)) {}

  // A straight edge of the carpet between two places on it.
  void addEdge(Point2<Field> a, Point2<Field> b) {
    const auto pixelOf = [this](Point2<Field> p) {
      const Point2<Robot> r = robotFromField(pose, p);
      return *body::project(board.body.camera, {r.x, r.y, 0.0});
    };
    const PixelPoint p = pixelOf(a);
    const PixelPoint q = pixelOf(b);
    const double slope = (q.y - p.y) / (q.x - p.x);
    board.edges.push_back({p.y - slope * p.x, p.y + slope * (kImageWidth - p.x), 20, 0.5});
  }

  LandmarkPercept beacon(LandmarkKind kind, Point2<Field> at) const {
    const Point2<Robot> r = robotFromField(pose, at);
    LandmarkPercept percept;
    percept.kind = kind;
    percept.distance = r.norm();
    percept.heading = bearing(r);
    return percept;
  }

  // The facts of a blue goal whose mouth's middle stands at a place, turned from where it faces by
  // `turn`.
  GoalFacts facts(Point2<Field> mouth, Angle turn = Angle(),
                  const Landmarks* beacons = nullptr) const {
    const Point2<Robot> r = robotFromField(pose, mouth);
    const Point3<Robot>& eye = board.body.camera.position;
    const Point2<Robot> middle{r.x - eye.x, r.y - eye.y};
    GoalCandidate c;
    c.colour = ColourClass::blue;
    const PixelPoint foot = *body::project(board.body.camera, {r.x, r.y, 0.0});
    const LevelPoint place = horizonFrameOf(board.body.camera).fromImage(foot);
    c.box = LevelBox{place.u - 5.0, place.v - 5.0, place.u + 5.0, place.v};
    const double along = (Angle::deg(90) - pose.heading + turn).rad();
    const Landmarks none;
    GoalFacts facts;
    addPlace(board.scene(), c, {true, middle, along, 0.0}, beacons != nullptr ? *beacons : none,
             facts);
    return facts;
  }
};

const Pose2 kBeforeTheGoal{{180, 300}, Angle::deg(90)};

TEST(GoalPlace, AGoalOnItsEdgeIsOffByNothing) {
  View view(kBeforeTheGoal);
  view.addEdge({100, 570}, {260, 570});
  const GoalFacts facts = view.facts({180, 540});
  EXPECT_NEAR(facts.edgeDistance, 0.0, 0.5);
  EXPECT_NEAR(facts.edgeTurn, 0.0, 0.2);
  EXPECT_NEAR(facts.edgeLateralOffset, 0.0, 0.5);
  EXPECT_EQ(facts.cornerError, 0.0);
  EXPECT_EQ(facts.beaconError, 0.0);
}

TEST(GoalPlace, ABoxBehindTheEdgeIsBehindItAndATurnedOneIsTurned) {
  View view(kBeforeTheGoal);
  view.addEdge({100, 570}, {260, 570});
  EXPECT_NEAR(view.facts({180, 600}).edgeDistance, -60.0, 0.5);
  EXPECT_NEAR(view.facts({180, 540}, Angle::deg(40)).edgeTurn, 40.0, 0.3);
  EXPECT_NEAR(view.facts({100, 540}).edgeLateralOffset, 80.0, 0.5);
}

TEST(GoalPlace, HalfACarpetFromTheCornerIsRight) {
  View view({{100, 330}, Angle::deg(110)});
  view.addEdge({40, 570}, {180, 570});
  view.addEdge({-20, 480}, {-20, 520});
  EXPECT_NEAR(view.facts({180, 540}).cornerError, 0.0, 1.0);
  EXPECT_NEAR(view.facts({80, 540}).cornerError, 100.0, 1.0);
}

TEST(GoalPlace, ABeaconTellsWhereItsGoalIs) {
  const View view({{180, 250}, Angle::deg(110)});
  Landmarks beacons;
  beacons.push_back(view.beacon(LandmarkKind::beaconBlueOnPink, {-15, 405}));
  const GoalFacts right = view.facts({180, 540}, {}, &beacons);
  EXPECT_NEAR(right.beaconError, 0.0, 0.5);
  EXPECT_NEAR(right.offCarpetDistance, 0.0, 0.5);
  EXPECT_GT(view.facts({60, 540}, {}, &beacons).beaconError, 80.0);
}

// As far from the beacon on its other side, which can be seen from off the carpet only.
TEST(GoalPlace, AGoalOnTheWrongSideOfABeaconPutsTheRobotOffTheCarpet) {
  const View view({{180, 250}, Angle::deg(110)});
  Landmarks beacons;
  beacons.push_back(view.beacon(LandmarkKind::beaconBlueOnPink, {-15, 405}));
  const GoalFacts facts = view.facts({-210, 540}, {}, &beacons);
  EXPECT_NEAR(facts.beaconError, 0.0, 0.5);
  EXPECT_GT(facts.offCarpetDistance, 50.0);
}

TEST(GoalPlace, NothingInTheImageLeavesTheFactsAtNothing) {
  const View view(kBeforeTheGoal);
  const GoalFacts facts = view.facts({180, 540});
  EXPECT_EQ(facts.edgeDistance, 0.0);
  EXPECT_EQ(facts.edgeTurn, 0.0);
  EXPECT_EQ(facts.offCarpetDistance, 0.0);
}

}  // namespace
}  // namespace kelpie::vision
