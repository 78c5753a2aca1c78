// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/StandingRobot.h"

#include <cmath>

namespace kelpie::experiments {
namespace {

constexpr double kPan = 1.2;          // rad to either side
constexpr int kPanFrames = 120;       // there and back: 3.6 deg a frame at most
constexpr double kHalfView = 28.0;    // deg
constexpr double kNearest = 25.0;     // cm
constexpr double kReach = 250.0;      // cm
constexpr double kSpacing = 10.0;     // cm of points along a line
constexpr double kPointShare = 0.03;  // of the distance, error of one point
constexpr double kPointTurn = 0.017;  // rad, the same
constexpr double kFrameShare = 0.015;
constexpr double kFrameTurn = 0.005;  // rad
constexpr double kStandingShare = 0.01;
constexpr double kStandingTurn = 0.003;  // rad
constexpr double kStartAway = 40.0;      // cm
constexpr double kStartTurn = 20.0;      // deg

}  // namespace

StandingRobot::StandingRobot(std::uint64_t seed) : random_(seed) {
  params.field = *body::fieldDescription("2006");
  input.elapsed = kFrameSeconds;
  const double x = random_.uniform(20.0, params.field.width - 20.0);
  const double y = random_.uniform(20.0, params.field.length - 20.0);
  truth = {{x, y}, Angle::rad(random_.uniform(-maths::kPi, maths::kPi))};
  standing_ = {random_.gaussian(1.0, kStandingShare), random_.gaussian(0.0, kStandingTurn)};
}

void StandingRobot::believeCoarsely() {
  const Angle way = Angle::rad(random_.uniform(-maths::kPi, maths::kPi));
  const double away = kStartAway * std::sqrt(random_.uniform(0.0, 1.0));
  const Angle turn = Angle::deg(random_.uniform(-kStartTurn, kStartTurn));
  params.initialPose.present = true;
  params.initialPose.pose = {truth.position + Point2<Field>{way.cos(), way.sin()} * away,
                             truth.heading + turn};
  params.initialPose.positionSd = 0.5 * kStartAway;  // of a coordinate, evenly in the circle
  params.initialPose.headingSd = Angle::deg(kStartTurn / std::sqrt(3.0));
}

void StandingRobot::look(bool landmarks) {
  const double phase = 2.0 * maths::kPi * input.frame / kPanFrames;
  pan_ = kPan * std::sin(phase);
  input.sensors.joints[Joint::headPan] = Angle::rad(pan_);
  input.headRate.headPan = kPan * std::cos(phase) * 2.0 * maths::kPi / (kPanFrames * kFrameSeconds);
  frame_ = {random_.gaussian(1.0, kFrameShare), random_.gaussian(0.0, kFrameTurn)};
  percepts = Percepts{};
  for (const body::FieldLine& line : params.field.lines) seeLine(line);
  seeCircle();
  seeCarpet();
  if (landmarks) seeLandmarks();
}

void StandingRobot::seeLine(const body::FieldLine& line) {
  const Point2<Field> way = line.end - line.start;
  const double length = way.norm();
  for (double at = random_.uniform(0.0, kSpacing); at < length; at += kSpacing)
    seePoint(line.start + way * (at / length), LinePointKind::line);
}

void StandingRobot::seeCircle() {
  const double radius = 0.5 * (params.field.circleDiameter - params.field.lineWidth);
  const Point2<Field> middle{params.field.width / 2, params.field.length / 2};
  const double first = random_.uniform(0.0, 1.0);
  for (int i = 0; i < 10; ++i) {
    const Angle around = Angle::rad(2.0 * maths::kPi * (i + first) / 10.0);
    seePoint(middle + Point2<Field>{around.cos(), around.sin()} * radius, LinePointKind::line);
  }
}

// Green within the lines, anywhere in the view.
void StandingRobot::seeCarpet() {
  for (int i = 0; i < 20; ++i) {
    const Point2<Robot> p = robotPolar(random_.uniform(kNearest, kReach),
                                       Angle::rad(pan_) + Angle::deg(random_.uniform(-28, 28)));
    const Point2<Field> place = fieldFromRobot(truth, p);
    if (place.x > 0.0 && place.x < params.field.width && place.y > 0.0 &&
        place.y < params.field.length)
      seePoint(place, LinePointKind::field);
  }
}

bool StandingRobot::inView(Point2<Robot> point) const {
  return (bearing(point) - Angle::rad(pan_)).abs().deg() < kHalfView;
}

void StandingRobot::seePoint(Point2<Field> place, LinePointKind kind) {
  const Point2<Robot> seen = robotFromField(truth, place);
  const double range = seen.norm();
  if (range < kNearest || range > kReach || !inView(seen)) return;
  // Fewer far away, where the grid's pixels lie farther apart than the lines are wide.
  if (!random_.chance(std::fmin(1.0, 60.0 / range))) return;
  const double scale = standing_.scale * frame_.scale * random_.gaussian(1.0, kPointShare);
  const double turn = standing_.turn + frame_.turn + random_.gaussian(0.0, kPointTurn);
  LinePoint p;
  p.kind = kind;
  p.position = robotPolar(range * scale, bearing(seen) + Angle::rad(turn));
  p.weight = kind == LinePointKind::field ? 1.0 : std::fmin(1.0, (350.0 - range) / 280.0);
  percepts.linePoints.push_back(p);
}

void StandingRobot::seeLandmarks() {
  for (const body::Landmark& landmark : body::landmarksFor(params.field, input.game.team)) {
    const Point2<Robot> seen = robotFromField(truth, landmark.position);
    if (!inView(seen)) continue;
    LandmarkPercept p;
    p.kind = landmark.kind;
    p.distance = seen.norm() * random_.gaussian(1.0, 0.06);
    p.heading = bearing(seen) + Angle::deg(random_.gaussian(0.0, 2.0));
    p.distanceVariance = maths::square(0.06 * seen.norm()) + 1.0;
    p.headingVariance = maths::square(2.0 * maths::kPi / 180.0);
    percepts.landmarks.push_back(p);
  }
}

WorldModel StandingRobot::step() {
  input.frame += 1;
  input.time = TimeUs::fromSeconds(input.frame * kFrameSeconds);
  return gps::step({input, percepts}, params, *state);
}

Pose2 StandingRobot::twin() const {
  return {{params.field.width - truth.position.x, params.field.length - truth.position.y},
          truth.heading + Angle::deg(180)};
}

StandingError standingError(const Pose2& believed, const Pose2& truth) {
  return {distance(believed.position, truth.position),
          (believed.heading - truth.heading).abs().deg()};
}

}  // namespace kelpie::experiments
