// SPDX-License-Identifier: Apache-2.0
#include "tools/percepts/Eye.h"

#include "robot/body/Camera.h"

namespace kelpie::percepts {
namespace {

void empty(Percepts& percepts) {
  percepts.ball = {};
  percepts.landmarks.clear();
  percepts.gaps.clear();
  percepts.robots.clear();
  percepts.obstacles.clear();
  percepts.obstaclesAhead = 0;
  percepts.fieldEdges.clear();
  percepts.linePoints.clear();
}

}  // namespace

void Eye::see(const FrameInput& /*input*/, const BodyState& body, Percepts& percepts) {
  empty(percepts);
  if (moment_ == nullptr) return;
  view_.turnTo(*moment_, robot_, body.camera);
  const Look look{view_, *moment_, field_, body, noise_, random_};
  seeFieldEdges(look, percepts);
  seeBall(look, percepts.ball);
  seeBeacons(look, percepts);
  seeGoals(look, percepts);
  seeRobots(look, percepts);
  seeFalseOnes(look, percepts);
  seeObstacles(look, percepts);
  seeLines(look, percepts);
}

double recallOf(const RecallByShare& recall, double shown) {
  if (shown <= 0.0) return 0.0;
  const auto last = static_cast<double>(recall.size() - 1);
  const auto step = static_cast<std::size_t>(maths::clamp(shown * last, 0.0, last));
  return recall[step];
}

void seeFalseOnes(const Look& look, Percepts& percepts) {
  constexpr double kNearest = 60.0;  // cm
  constexpr double kFarthest = 230.0;
  constexpr double kHalfView = 25.0;  // deg
  constexpr double kShare = 0.15;     // of the distance, as it is said of a robot
  const auto anywhere = [&](auto& percept) {
    const Point3<Robot> ahead =
        body::rayThrough(look.view.believed(), {0.5 * kImageWidth, 0.5 * kImageHeight});
    percept.distance = look.random.uniform(kNearest, kFarthest);
    percept.heading = bearing(Point2<Robot>{ahead.x, ahead.y}) +
                      Angle::deg(look.random.uniform(-kHalfView, kHalfView));
    percept.distanceVariance = maths::square(kShare * percept.distance);
    percept.headingVariance = maths::square(Angle::deg(1.0).rad());
  };
  if (look.random.chance(look.noise.falseOnes.robots)) {
    RobotPercept robot;
    robot.team = look.random.chance(0.5) ? TeamColour::red : TeamColour::blue;
    anywhere(robot);
    percepts.robots.push_back(robot);
  }
  if (look.random.chance(look.noise.falseOnes.beacons)) {
    LandmarkPercept beacon;
    beacon.kind = static_cast<LandmarkKind>(2 + look.random.index(4));
    anywhere(beacon);
    beacon.leftEdge = beacon.rightEdge = beacon.heading;
    percepts.landmarks.push_back(beacon);
  }
}

ElevationError elevationErrorAt(const Look& look, PixelPoint pixel, double height, double distance,
                                double variance) {
  const CameraPose& camera = look.view.believed();
  const double stands = (height - camera.position.z) / distance;
  const double seen = readSlope(camera, pixel);
  return {Angle::rad(maths::atan(seen) - maths::atan(stands)), variance};
}

}  // namespace kelpie::percepts
