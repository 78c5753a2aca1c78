// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/world/Observer.h"

#include <algorithm>
#include <cmath>

namespace kelpie::sim {
namespace {

constexpr double kStepTime = 0.35;  // s of one step of the walk
constexpr double kNearest = 25.0;   // cm, of points on lines and carpet
constexpr double kFarthest = 250.0;
constexpr double kSpacing = 10.0;      // cm of points along a line
constexpr double kBallRadius = 806.0;  // px at 1 cm
constexpr double kDegree = maths::kPi / 180.0;

}  // namespace

double panAt(int frame) { return 1.2 * std::sin(2.0 * maths::kPi * frame / 60.0); }

Observer::Observer(TruePose start, std::uint64_t seed, const ObserverNoise& errors)
    : truth(start), noise(errors), random_(seed), elevations_(seed + 0x51ed) {
  input.elapsed = kFrameSeconds;
}

double Observer::slip() {
  if (noise.walk.slipSd <= 0.0) return noise.walk.slip;
  slipLeft_ -= kFrameSeconds;
  if (slipLeft_ > 0.0) return slip_;
  slip_ = random_.gaussian(noise.walk.slip, noise.walk.slipSd);
  slipLeft_ = kStepTime;
  return slip_;
}

void Observer::walk(double forward, double left, double turn) {
  constexpr int kSteps = 20;
  const double kept = 1.0 - slip();
  for (int i = 0; i < kSteps; ++i) {
    const double ahead = forward * kept;
    const double lateral = left * kept;
    truth.heading += turn * kept / kSteps;
    truth.x += (ahead * std::cos(truth.heading) - lateral * std::sin(truth.heading)) / kSteps;
    truth.y += (ahead * std::sin(truth.heading) + lateral * std::cos(truth.heading)) / kSteps;
  }
  const double way = std::hypot(forward, left);
  if (noise.walk.headingPerCm > 0.0)
    truth.heading += noise.walk.headingPerCm * std::sqrt(way) * random_.gaussian();
  input.odometry = {forward, left, Angle::rad(turn), {}};
  walking_ = way > 0.0 || turn != 0.0;
  phase_ += 2.0 * maths::kPi * kFrameSeconds / (2.0 * kStepTime);
}

Observer::Polar Observer::polarOf(Point2<Field> place) const {
  const double dx = place.x - truth.x;
  const double dy = place.y - truth.y;
  return {std::sqrt(dx * dx + dy * dy), std::atan2(dy, dx) - truth.heading};
}

Angle Observer::bearingOf(Point2<Field> place) const { return Angle::rad(polarOf(place).bearing); }

bool Observer::inView(Angle heading, double pan) const {
  return (heading - Angle::rad(pan)).abs().deg() < noise.halfView;
}

LandmarkPercept Observer::look(const body::Landmark& landmark, bool noisy) {
  const Polar real = polarOf(landmark.position);
  LandmarkPercept p;
  p.kind = landmark.kind;
  p.distance = real.range * (noisy ? random_.gaussian(1.0, noise.landmarkShare) : 1.0);
  p.heading =
      Angle::rad(real.bearing + (noisy ? random_.gaussian(0.0, noise.landmarkHeading) : 0.0));
  p.distanceVariance = maths::square(noise.landmarkShare * real.range) + 1.0;
  p.headingVariance = maths::square(noise.landmarkHeading);
  if (noisy) p.elevationError.value = Angle::rad(elevations_.gaussian(0.0, noise.elevation));
  p.elevationError.variance = maths::square(noise.elevation);
  return p;
}

void Observer::lookAround(double pan) {
  percepts.landmarks.clear();
  for (const body::Landmark& landmark : body::landmarksFor(field, input.game.team)) {
    const LandmarkPercept p = look(landmark);
    if (inView(p.heading, pan)) percepts.landmarks.push_back(p);
  }
}

void Observer::falsify(double share, Random& random) {
  for (LandmarkPercept& p : percepts.landmarks)
    if (random.chance(share)) p.heading = p.heading + Angle::deg(random.uniform(20.0, 340.0));
}

Observer::SharedError Observer::drawn(const PointNoise& sd) {
  const double scale = random_.gaussian(1.0, sd.share);
  return {scale, random_.gaussian(0.0, sd.turn)};
}

void Observer::drawStandingErrors() { standing_ = drawn(noise.standing); }

void Observer::lookAtLines(double pan) {
  percepts.linePoints.clear();
  frame_ = drawn(noise.frame);
  for (const body::FieldLine& line : field.lines) {
    const Point2<Field> way = line.end - line.start;
    const double length = std::hypot(way.x, way.y);
    for (double at = random_.uniform(0.0, kSpacing); at < length; at += kSpacing)
      addPoint(line.start + way * (at / length), LinePointKind::line, pan);
  }
}

void Observer::lookAtCircleAndCarpet(double pan) {
  const double radius = 0.5 * (field.circleDiameter - field.lineWidth);
  const double first = random_.uniform(0.0, 1.0);
  for (int i = 0; i < 10; ++i) {
    const double around = 2.0 * maths::kPi * (i + first) / 10.0;
    const Point2<Field> off{radius * std::cos(around), radius * std::sin(around)};
    addPoint(Point2<Field>{field.width / 2, field.length / 2} + off, LinePointKind::line, pan);
  }
  for (int i = 0; i < 20; ++i) {
    const double range = random_.uniform(kNearest, kFarthest);
    const double way =
        truth.heading + pan + kDegree * random_.uniform(-noise.halfView, noise.halfView);
    const Point2<Field> place{truth.x + range * std::cos(way), truth.y + range * std::sin(way)};
    if (place.x > 0.0 && place.x < field.width && place.y > 0.0 && place.y < field.length)
      addPoint(place, LinePointKind::field, pan);
  }
}

void Observer::addPoint(Point2<Field> place, LinePointKind kind, double pan) {
  const Polar seen = polarOf(place);
  if (seen.range < kNearest || seen.range > kFarthest) return;
  if (Angle::rad(seen.bearing - pan).abs().deg() > noise.halfView) return;
  // Fewer far away, where the grid's pixels lie farther apart than the lines are wide.
  if (!random_.chance(std::fmin(1.0, 60.0 / seen.range))) return;
  const double turn = standing_.turn + frame_.turn;
  const Angle heading = Angle::rad(seen.bearing + turn + random_.gaussian(0.0, noise.point.turn));
  const double scale = standing_.scale * frame_.scale;
  LinePoint p;
  p.kind = kind;
  p.position = robotPolar(seen.range * scale * random_.gaussian(1.0, noise.point.share), heading);
  p.weight = kind == LinePointKind::field ? 1.0 : std::fmin(1.0, (350.0 - seen.range) / 280.0);
  percepts.linePoints.push_back(p);
}

void Observer::lookAtBall(Point2<Field> ball) {
  const BallNoise& errors = noise.ball;
  const Polar real = polarOf(ball);
  double off = random_.gaussian(0.0, errors.heading);
  if (walking_ && errors.oscillation)
    off += std::sqrt(2.0) * errors.walkingHeading * std::sin(phase_);
  if (walking_ && !errors.oscillation) off += random_.gaussian(0.0, errors.walkingHeading);
  BallPercept& p = percepts.ball;
  p.present = true;
  p.distance =
      real.range * (1.0 + errors.distanceBias + random_.gaussian(0.0, errors.distanceShare));
  p.heading = Angle::rad(real.bearing) + Angle::deg(off);
  // As vision's BallFinder says: 0.3 px of the radius, 0.7 deg.
  p.distanceVariance = maths::square(0.3 * p.distance * p.distance / kBallRadius);
  p.headingVariance = maths::square(0.7 * kDegree);
  p.centre = {0.5 * kImageWidth, 0.5 * kImageHeight};
  p.radius = kBallRadius / p.distance;
}

void Observer::lookAtOpponents(const std::vector<Point2<Field>>& opponents, double pan) {
  const OpponentNoise& errors = noise.opponents;
  lasting_.resize(opponents.size());
  for (std::size_t i = 0; i < opponents.size(); ++i) {
    Lasting& lasting = lasting_[i];
    lasting.secondsLeft -= kFrameSeconds;
    if (lasting.secondsLeft <= 0.0) lasting = {random_.gaussian(0.0, errors.share), 1.0};
    const Polar real = polarOf(opponents[i]);
    const Angle heading = Angle::rad(real.bearing);
    if (!inView(heading, pan) || real.range > errors.reach || !random_.chance(errors.recall))
      continue;
    RobotPercept p;
    p.team = input.game.team == TeamColour::red ? TeamColour::blue : TeamColour::red;
    const double share = lasting.share + random_.gaussian(0.0, errors.share);
    p.distance = real.range * std::max(0.3, 1.0 + share);
    p.heading = heading + Angle::deg(random_.gaussian(0.0, errors.heading));
    p.distanceVariance = maths::square(0.15 * p.distance);
    p.headingVariance = maths::square(errors.heading * kDegree);
    percepts.robots.push_back(p);
  }
}

}  // namespace kelpie::sim
