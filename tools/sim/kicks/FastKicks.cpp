// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/kicks/FastKicks.h"

#include <cmath>

#include "tools/sim/kicks/KickTable.h"

namespace kelpie::sim {
namespace {

using actuator::KeyFrame;
using actuator::KeyLegs;
using actuator::MotionData;

// Where a ball is held (tools/learn/motion/BallInHold.h), and where it then lies, from the neck
// base, cm.
constexpr double kNearest = 3.0;
constexpr double kFurthest = 10.8;
constexpr double kLateral = 4.5;
constexpr double kHeldAhead = 7.9;
constexpr double kDrawnIn = 0.1;  // share of the way there, a tick
constexpr std::size_t kFirstLegJoint = index(Joint::leftFrontRotator);
constexpr double kWalkSlew = 4.5;  // deg a tick: only motions command more
constexpr double kSame = 0.3;      // deg by which commanded angles may differ from a key frame's
constexpr double kStands = 2.5;    // cm/s: a slower robot stands, as the kick map has it
constexpr double kStops = 0.25;    // s that a walk may end before a kick from it [chosen]
constexpr double kSure = 1.2;      // cm from the kick's place at which its figures were measured,
constexpr double kOff = 4.0;       // and at which nothing is left of it

bool headDown(const JointAngles& target) {
  constexpr double kNeck = -38.0;  // deg; the grab that lifts the head holds the ball at -40
  constexpr double kNod = 30.0;
  return target[Joint::neckTilt].deg() < kNeck && target[Joint::headNod].deg() > kNod;
}

bool canHold(Point2<Robot> ball) {
  return ball.y > kNearest && ball.y < kFurthest && std::fabs(ball.x) < kLateral;
}

// A hard forward or a wedge at a ball that lies free does what its file says, at the place where it
// was searched; a ball further to the side goes less far.
KickCell ofItsFile(MotionKind kind, Point2<Robot> ball) {
  const actuator::KickEffect& effect = actuator::standardMotions()[kind].kick;
  const double off = maths::hypot(ball.x + effect.left, ball.y - effect.ahead);
  const double share = maths::clamp((kOff - off) / (kOff - kSure), 0.0, 1.0);
  KickCell cell;
  cell.went = share > 0.0 ? 1.0 : 0.0;
  cell.direction = effect.direction;
  cell.directionSd = effect.directionSd * (1.0 + 2.0 * (1.0 - share));
  cell.distance = share * effect.distance;
  cell.distanceSd = share * effect.distanceSd;
  return cell;
}

// The legs of a kick's key frame as the actuator's clamp lets them be commanded.
struct KickFrame {
  JointAngles joints;
  MotionKind motion = MotionKind::none;
  std::size_t left = 0;  // key frames still to come
};

std::vector<KickFrame> kickFrames() {
  std::vector<KickFrame> frames;
  for (std::size_t k = 0; k < kMotionKindCount; ++k) {
    const MotionData& motion = actuator::standardMotions().of[k];
    const auto kind = static_cast<MotionKind>(k);
    if (!isKick(kind)) continue;
    for (std::size_t f = 0; f < motion.frames.size(); ++f) {
      const KeyFrame& key = motion.frames[f];
      if (key.legs != KeyLegs::angles) continue;
      KickFrame frame{{}, kind, motion.frames.size() - 1 - f};
      for (std::size_t j = 0; j < actuator::kLegJoints; ++j)
        frame.joints.angle[kFirstLegJoint + j] = key.angles[j];
      frame.joints = body::withinLimits(frame.joints);
      frames.push_back(frame);
    }
  }
  return frames;
}

// The greatest difference of a leg joint, deg.
double legsApart(const JointAngles& a, const JointAngles& b) {
  double max = 0.0;
  for (std::size_t j = kFirstLegJoint; j < kFirstLegJoint + actuator::kLegJoints; ++j)
    max = std::fmax(max, std::fabs((a.angle[j] - b.angle[j]).deg()));
  return max;
}

const KickFrame* played(const JointAngles& target) {
  static const std::vector<KickFrame> frames = kickFrames();
  for (const KickFrame& frame : frames)
    if (legsApart(frame.joints, target) < kSame) return &frame;
  return nullptr;
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

void FastKicks::kick(MotionKind kind, Grip& grip, Ball& ball) {
  grip.kicked = true;
  const Point2<Robot> at = robotFromField(grip.start, ball.position);
  const bool walks = grip.stands < kStops;
  const auto known = grip.holds ? heldKick(kind) : freeKick(kind, walks, at);
  grip.holds = false;
  const KickCell cell = known ? *known : ofItsFile(kind, at);
  if (cell.went <= 0.0) return;
  const double far = std::fmax(0.0, random_.gaussian(cell.distance, cell.distanceSd));
  const double distance = random_.chance(cell.went) ? far : random_.uniform(0.0, kBallGoes);
  const Angle heading = grip.start.heading + cell.direction + cell.directionSd * random_.gaussian();
  const double speed = speedToRoll(distance, ball_);
  ball.velocity = {speed * heading.cos(), speed * heading.sin()};
}

bool FastKicks::tick(std::size_t robot, const RobotModel& body, Ball& ball) {
  if (robot >= grips_.size()) grips_.resize(robot + 1);
  Grip& grip = grips_[robot];
  const JointAngles& target = body.target();
  const double slew = legsApart(target, grip.target);
  grip.target = target;
  const KickFrame* frame = played(target);
  if (frame == nullptr && slew <= kWalkSlew) {
    grip.kicked = false;
    grip.start = body.place().pose;
    // One that is pushed goes along without its legs.
    const Point2<Field> was = body.placeBefore().pose.position;
    const bool goes = distance(grip.start.position, was) > kStands * kTickSeconds;
    grip.stands = goes && slew > 0.0 ? 0.0 : grip.stands + kTickSeconds;
    const bool taken = holder().value_or(robot) != robot;  // by another one
    grip.holds = !taken && holdingPose(target) && hold(body, grip, ball);
    // A head that comes down with its jaw shut passes in front of the ball.
    const Point2<Robot> at = robotFromField(grip.start, ball.position);
    return grip.holds || (headDown(target) && canHold(at));
  }
  // A held ball stays where the motion began, until its last key frame.
  if (grip.holds) ball.velocity = {};
  if (frame != nullptr && frame->left == 0 && !grip.kicked) kick(frame->motion, grip, ball);
  return true;
}

}  // namespace kelpie::sim
