// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/FastKicks.h"

#include <cmath>

namespace kelpie::sim {
namespace {

using actuator::KeyFrame;
using actuator::KeyLegs;
using actuator::MotionData;

// Where a ball is held (tools/learn/HeldBall.h), and where it then lies, from the neck base, cm.
constexpr double kNearest = 3.0;
constexpr double kFurthest = 10.8;
constexpr double kAside = 4.5;
constexpr double kHeldAhead = 7.9;
constexpr double kDrawnIn = 0.1;  // share of the way there, a tick
constexpr double kSame = 0.3;     // deg by which commanded angles may differ from a key frame's
constexpr double kSure = 1.2;     // cm from the kick's place at which its figures were measured,
constexpr double kOff = 4.0;      // and at which nothing is left of it

bool headDown(const JointAngles& target) {
  constexpr double kNeck = -45.0;  // deg
  constexpr double kNod = 30.0;
  return target[Joint::neckTilt].deg() < kNeck && target[Joint::headNod].deg() > kNod;
}

bool canHold(Point2<Robot> ball) {
  return ball.y > kNearest && ball.y < kFurthest && std::fabs(ball.x) < kAside;
}

bool legsAt(const KeyFrame& key, const JointAngles& target) {
  if (key.legs != KeyLegs::angles) return false;
  for (std::size_t j = 0; j < actuator::kLegJoints; ++j) {
    const Angle at = target.angle[index(Joint::leftFrontRotator) + j];
    if (std::fabs((at - key.angles[j]).deg()) > kSame) return false;
  }
  return true;
}

// The kick that the robot is commanded into, and how many key frames are still to come.
struct Playing {
  const MotionData* motion = nullptr;
  std::size_t left = 0;
};

Playing played(const JointAngles& target) {
  for (std::size_t k = 0; k < kMotionKindCount; ++k) {
    const MotionData& motion = actuator::standardMotions().of[k];
    if (!isKick(static_cast<MotionKind>(k))) continue;
    for (std::size_t f = 0; f < motion.frames.size(); ++f)
      if (legsAt(motion.frames[f], target)) return {&motion, motion.frames.size() - 1 - f};
  }
  return {};
}

// dv/dt = -(k v + friction), as roll() has it.
double rollOut(double speed, double k, double friction) {
  return speed / k - friction / (k * k) * std::log1p(k * speed / friction);
}

}  // namespace

double speedToRoll(double distance, const BallParams& params) {
  constexpr double kFrames = 30.0;  // of keptPerFrame
  const double k = -kFrames * std::log(params.keptPerFrame);
  double low = 0.0;
  double high = params.maxSpeed;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (rollOut(middle, k, params.friction) < distance ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

bool holdingPose(const JointAngles& target) {
  constexpr double kMouth = -40.0;  // deg
  return headDown(target) && target[Joint::mouth].deg() < kMouth;
}

bool FastKicks::hold(const RobotModel& body, Grip& grip, Ball& ball) const {
  const Pose2& pose = body.place().pose;
  if (!grip.holds) {
    grip.place = robotFromField(pose, ball.position);
    grip.holds = canHold(grip.place);
  }
  if (!grip.holds) return false;
  grip.place.x -= kDrawnIn * grip.place.x;
  grip.place.y += kDrawnIn * (kHeldAhead - grip.place.y);
  const Point2<Field> at = fieldFromRobot(pose, grip.place);
  const Point2<Field> was = fieldFromRobot(body.placeBefore().pose, grip.place);
  ball = {at, (at - was) * (1.0 / kTickSeconds)};
  return true;
}

void FastKicks::kick(const actuator::KickEffect& effect, const RobotModel& body, Grip& grip,
                     Ball& ball) {
  grip.kicked = true;
  const Pose2& pose = body.place().pose;
  const Point2<Robot> at = robotFromField(pose, ball.position);
  const double off = maths::hypot(at.x + effect.left, at.y - effect.ahead);
  const double share = maths::clamp((kOff - off) / (kOff - kSure), 0.0, 1.0);
  const double distance =
      share * std::fmax(0.0, random_.gaussian(effect.distance, effect.distanceSd));
  const double wide = 1.0 + 2.0 * (1.0 - share);
  const Angle way = effect.direction + effect.directionSd * (wide * random_.gaussian());
  if (distance <= 0.0) return;
  const Angle heading = pose.heading + way;
  const double speed = speedToRoll(distance, ball_);
  ball.velocity = {speed * heading.cos(), speed * heading.sin()};
}

bool FastKicks::tick(std::size_t robot, const RobotModel& body, Ball& ball) {
  if (robot >= grips_.size()) grips_.resize(robot + 1);
  Grip& grip = grips_[robot];
  const Playing now = played(body.target());
  if (now.motion == nullptr) {
    grip.kicked = false;
    grip.holds = holdingPose(body.target()) && hold(body, grip, ball);
    // A head that comes down with its jaw shut passes in front of the ball.
    const Point2<Robot> at = robotFromField(body.place().pose, ball.position);
    return grip.holds || (headDown(body.target()) && canHold(at));
  }
  // A held ball stays until the kick's last key frame.
  if (grip.holds && !grip.kicked) hold(body, grip, ball);
  if (now.left == 0 && !grip.kicked) {
    kick(now.motion->kick, body, grip, ball);
    grip.holds = false;
  }
  return true;
}

}  // namespace kelpie::sim
