// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/world/LocalisingRobot.h"

#include <cmath>

#include "robot/body/Camera.h"

namespace kelpie::sim {
namespace {

constexpr double kPan = 1.2;          // rad to either side
constexpr int kPanFrames = 120;       // there and back: 3.6 deg a frame at most
constexpr double kFromBorder = 20.0;  // cm, of a random place
constexpr double kStartAway = 40.0;   // cm
constexpr double kStartTurn = 20.0;   // deg

ObserverNoise standingNoise() {
  ObserverNoise noise;
  noise.standing = {0.01, 0.003};
  return noise;
}

}  // namespace

LocalisingRobot::LocalisingRobot(TruePose start, std::uint64_t seed, const ObserverNoise& errors)
    : Observer(start, seed, errors) {
  params.field = field;
  // Made sightings come from a body that stands as its joints say, and from no lens.
  params.tilt.use = false;
  params.focal.use = false;
}

void LocalisingRobot::believe(const Pose2& pose, double positionSd, Angle headingSd) {
  params.initialPose = {true, pose, positionSd, headingSd};
}

WorldModel LocalisingRobot::step() {
  input.frame += 1;
  input.time = TimeUs::fromSeconds(input.frame * kFrameSeconds);
  return localise({input, percepts, body::step(input, {}).camera}, params, state);
}

double LocalisingRobot::error(const WorldModel& world) const {
  return std::hypot(world.pose.position.x - truth.x, world.pose.position.y - truth.y);
}

double LocalisingRobot::headingError(const WorldModel& world) const {
  return (world.pose.heading - Angle::rad(truth.heading)).abs().deg();
}

StandingRobot::StandingRobot(std::uint64_t seed) : LocalisingRobot({}, seed, standingNoise()) {
  truth.x = random_.uniform(kFromBorder, field.width - kFromBorder);
  truth.y = random_.uniform(kFromBorder, field.length - kFromBorder);
  truth.heading = random_.uniform(-maths::kPi, maths::kPi);
  drawStandingErrors();
}

void StandingRobot::believeCoarsely() {
  const double way = random_.uniform(-maths::kPi, maths::kPi);
  const double away = kStartAway * std::sqrt(random_.uniform(0.0, 1.0));
  const double turn = random_.uniform(-kStartTurn, kStartTurn);
  const Point2<Field> off{away * std::cos(way), away * std::sin(way)};
  const Pose2 believed{truth.pose().position + off, truth.pose().heading + Angle::deg(turn)};
  // Of one coordinate, and of an even distribution.
  believe(believed, 0.5 * kStartAway, Angle::deg(kStartTurn / std::sqrt(3.0)));
}

void StandingRobot::look(bool landmarks) {
  const double phase = 2.0 * maths::kPi * input.frame / kPanFrames;
  const double pan = kPan * std::sin(phase);
  input.sensors.joints[Joint::headPan] = Angle::rad(pan);
  input.headRate.headPan = kPan * std::cos(phase) * 2.0 * maths::kPi / (kPanFrames * kFrameSeconds);
  percepts = Percepts{};
  lookAtLines(pan);
  lookAtCircleAndCarpet(pan);
  if (landmarks) lookAround(pan);
}

Pose2 StandingRobot::twin() const {
  return {{field.width - truth.x, field.length - truth.y}, truth.pose().heading + Angle::deg(180)};
}

BeliefError beliefError(const Pose2& believed, const Pose2& truth) {
  return {distance(believed.position, truth.position),
          (believed.heading - truth.heading).abs().deg()};
}

}  // namespace kelpie::sim
