// SPDX-License-Identifier: Apache-2.0
#include "tools/experiments/players/Player.h"

#include <algorithm>
#include <cmath>

namespace kelpie::experiments {
namespace {

constexpr double kFrame = kFrameSeconds;
constexpr double kStepTime = 0.35;  // s of one step of the walk
constexpr double kRadian = maths::kPi / 180.0;
constexpr double kHalfView = 26.0;     // deg
constexpr double kRobotReach = 200.0;  // cm, to which vision finds robots
constexpr double kRobotRecall = 0.82;  // and how often
constexpr double kRobotShare = 0.106;  // of the distance, twice: anew and for a second; 15 %
constexpr double kRobotHeading = 2.0;  // deg

Point2<Field> stepped(const Pose2& pose, double forward, double left) {
  return fieldFromRobot(pose, {-left, forward});
}

}  // namespace

TruePlayer::TruePlayer(Pose2 start, std::uint8_t player, std::uint64_t seed)
    : truth(start), random_(seed) {
  params.field = *body::fieldDescription("2006");
  input.elapsed = kFrame;
  input.game.player = player;
  input.sensors.joints[Joint::neckTilt] = Angle::deg(-10.0);
}

void TruePlayer::believe(Pose2 pose, double positionSd, Angle headingSd) {
  params.initialPose = {true, pose, positionSd, headingSd};
}

void TruePlayer::walk(const WalkSpeed& speed) {
  slipLeft_ -= kFrame;
  if (slipLeft_ <= 0.0) {
    slip_ = random_.gaussian(0.02, 0.03);
    slipLeft_ = kStepTime;
  }
  const double kept = (1.0 - slip_) * kFrame;
  const double way = maths::hypot(speed.forward, speed.left) * kFrame;
  const Angle half = Angle::rad(0.5 * speed.turn * kept);
  const Pose2 middle{truth.position, truth.heading + half};
  truth.position = stepped(middle, speed.forward * kept, speed.left * kept);
  truth.heading =
      truth.heading + half + half + Angle::rad(6e-4 * std::sqrt(way) * random_.gaussian());
  input.odometry = {speed.forward * kFrame, speed.left * kFrame, Angle::rad(speed.turn * kFrame)};
  walking_ = way > 0.0 || speed.turn != 0.0;
  phase_ += 2.0 * maths::kPi * kFrame / (2.0 * kStepTime);
}

void TruePlayer::look(double pan) {
  pan_ = pan;
  percepts = Percepts{};
  input.sensors.joints[Joint::headPan] = Angle::rad(pan);
}

bool TruePlayer::inView(Angle heading) const {
  return (heading - Angle::rad(pan_)).abs().deg() < kHalfView;
}

Angle TruePlayer::bearingOf(Point2<Field> point) const {
  return bearing(robotFromField(truth, point));
}

void TruePlayer::seeLandmarks() {
  for (const body::Landmark& landmark : body::landmarksFor(params.field, input.game.team)) {
    const double range = distance(truth.position, landmark.position);
    LandmarkPercept p;
    p.kind = landmark.kind;
    p.distance = range * random_.gaussian(1.0, 0.06);
    p.heading = bearingOf(landmark.position) + Angle::deg(random_.gaussian(0.0, 2.0));
    p.distanceVariance = maths::square(0.06 * range) + 1.0;
    p.headingVariance = maths::square(2.0 * kRadian);
    if (inView(p.heading)) percepts.landmarks.push_back(p);
  }
}

void TruePlayer::seeBall(Point2<Field> ball, const BallNoise& noise) {
  const double range = distance(truth.position, ball);
  double off = random_.gaussian(0.0, noise.heading);
  if (walking_ && noise.sway) off += std::sqrt(2.0) * noise.walkingHeading * maths::sin(phase_);
  if (walking_ && !noise.sway) off += random_.gaussian(0.0, noise.walkingHeading);
  BallPercept& p = percepts.ball;
  p.present = true;
  p.distance = range * (1.0 + noise.distanceBias + random_.gaussian(0.0, noise.distanceShare));
  p.heading = bearingOf(ball) + Angle::deg(off);
  // As vision's BallFinder says: 0.3 px of the radius, 0.7 deg.
  p.distanceVariance = maths::square(0.3 * p.distance * p.distance / 806.0);
  p.headingVariance = maths::square(0.7 * kRadian);
  p.centre = {0.5 * kImageWidth, 0.5 * kImageHeight};
  p.radius = 806.0 / p.distance;
}

void TruePlayer::seeOpponents(const std::vector<Point2<Field>>& opponents) {
  repeated_.resize(opponents.size());
  for (std::size_t i = 0; i < opponents.size(); ++i) {
    Repeated& error = repeated_[i];
    error.left -= kFrame;
    if (error.left <= 0.0) error = {random_.gaussian(0.0, kRobotShare), 1.0};
    const double range = distance(truth.position, opponents[i]);
    const Angle heading = bearingOf(opponents[i]);
    if (!inView(heading) || range > kRobotReach || !random_.chance(kRobotRecall)) continue;
    RobotPercept p;
    p.team = input.game.team == TeamColour::red ? TeamColour::blue : TeamColour::red;
    const double share = error.share + random_.gaussian(0.0, kRobotShare);
    p.distance = range * std::max(0.3, 1.0 + share);
    p.heading = heading + Angle::deg(random_.gaussian(0.0, kRobotHeading));
    p.distanceVariance = maths::square(0.15 * p.distance);
    p.headingVariance = maths::square(kRobotHeading * kRadian);
    percepts.robots.push_back(p);
  }
}

WorldModel TruePlayer::step() {
  input.frame += 1;
  input.time = TimeUs::fromSeconds(input.frame * kFrame);
  return gps::step({input, percepts}, params, *state_);
}

WorldModel TruePlayer::stepAlone() {
  const FixedVector<TeamMessage, kTeammates> team = input.team;
  input.team.clear();
  const WorldModel world = gps::step({input, percepts}, params, *alone_);
  input.team = team;
  return world;
}

void Wanderer::step(double speed, const std::vector<Point2<Field>>& others) {
  constexpr double kLength = 30.0;
  timeLeft_ -= kFrame;
  if (timeLeft_ <= 0.0 || distance(target_, position) < 10.0) {
    target_ = {random_.uniform(20, 340), random_.uniform(20, 520)};
    timeLeft_ = random_.uniform(2.0, 12.0);
  }
  const Point2<Field> way = target_ - position;
  const double far = std::max(way.norm(), 1e-6);
  const Point2<Field> next = position + way * (speed * kFrame / far);
  for (const Point2<Field>& other : others) {
    if (distance(other, position) < 1e-9) continue;  // itself
    if (distance(other, next) < kLength && distance(other, next) < distance(other, position)) {
      timeLeft_ = 0.0;  // somewhere else, then
      return;
    }
  }
  position = next;
}

void Radio::send(std::size_t from, const TeamMessage& message) {
  if (message.number == 0 || message.number == lastNumber_[from]) return;
  lastNumber_[from] = message.number;
  if (random_.chance(0.1)) return;
  underWay_.push_back({from, 1 + static_cast<int>(random_.index(3)), message});
}

void Radio::pass() {
  underWay_.erase(std::remove_if(underWay_.begin(), underWay_.end(),
                                 [](const Letter& letter) { return letter.frames <= 0; }),
                  underWay_.end());
  for (Letter& letter : underWay_) {
    --letter.frames;
    letter.message.age += kFrame;
  }
}

FixedVector<TeamMessage, kTeammates> Radio::receive(std::size_t to) {
  FixedVector<TeamMessage, kTeammates> list;
  for (const Letter& letter : underWay_) {
    if (letter.frames <= 0 && letter.from != to) list.push_back(letter.message);
  }
  return list;
}

}  // namespace kelpie::experiments
