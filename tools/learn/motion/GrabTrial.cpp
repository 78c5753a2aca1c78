// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/motion/GrabTrial.h"

#include <cmath>

#include "actuator/motion/MotionPlayer.h"

namespace kelpie::learn {
namespace {

constexpr int kApproach = 250;  // messages, 8 s
constexpr int kAfter = 16;      // 0.5 s
// The ball is that far ahead of the neck base, its closing speed counted, when the grab begins
// (physics.md section 10).
constexpr double kBegin = 9.2;          // cm
constexpr double kBeginSeconds = 0.13;  // of closing
constexpr double kBeginLateral = 3.5;   // cm
constexpr double kFast = 32.0;          // cm/s of the approach
constexpr double kSlow = 20.0;          // and close to the ball
constexpr double kClose = 25.0;         // cm
constexpr double kTurnGain = 3.5;       // 1/s
constexpr double kSideGain = 2.5;       // 1/s
constexpr double kLate = 0.1;           // s that what the robot does comes later

// Where the robot thinks the ball is, one message late, in its frame of now.
struct Sight {
  Point2<Robot> ball;
  Point2<Robot> velocity;  // over the ground
};

class Eyes {
 public:
  Eyes(const GrabPlace& place, Random& random)
      : off_{random.gaussian(0.0, place.error), random.gaussian(0.0, place.error)} {}

  Sight look(PhysicalWalker& walker) {
    const sim::Ball now = walker.bodies().ball();
    const sim::Ball ball = has_ ? last_ : now;
    last_ = now;
    has_ = true;
    const Pose2 pose = walker.pose();
    const Point2<Robot> at = robotFromField(pose, ball.position);
    const Point2<Robot> then = robotFromField(pose, ball.position + ball.velocity);
    return {{at.x + off_.x, at.y + off_.y}, then - at};
  }

 private:
  Point2<Robot> off_;
  sim::Ball last_;
  bool has_ = false;
};

// Where the ball will be when the robot is there.
Point2<Robot> meeting(const Sight& sight) {
  Point2<Robot> at = sight.ball;
  for (int i = 0; i < 4; ++i) {
    const double seconds = kLate + std::fmax(0.0, at.norm() - kBegin) / kFast;
    at = sight.ball + sight.velocity * seconds;
  }
  return at;
}

WalkRequest towards(const Sight& sight) {
  const Point2<Robot> at = meeting(sight);
  const double bearing = std::atan2(-at.x, at.y);  // left
  WalkRequest request;
  request.turn = maths::clamp(kTurnGain * bearing, -3.0, 3.0);
  const double speed = at.y < kClose ? kSlow : kFast;
  request.forward = speed * std::fmax(0.0, std::cos(1.5 * maths::clamp(bearing, -1.0, 1.0)));
  if (at.y < kClose) request.left = maths::clamp(-kSideGain * at.x, -12.0, 12.0);
  return request;
}

bool canGrab(const Sight& sight, double speed) {
  const double closing = speed - sight.velocity.y;
  const double lateral = sight.ball.x + kBeginSeconds * sight.velocity.x;
  return sight.ball.y - kBeginSeconds * closing < kBegin && sight.ball.y > 0.0 &&
         std::fabs(lateral) < kBeginLateral;
}

bool approach(const GrabPlace& place, Random& random, PhysicalWalker& walker) {
  Eyes eyes(place, random);
  Command command;
  command.head.neckTilt = Angle::deg(-25.0);
  for (int i = 0; i < kApproach && !walker.fallen(); ++i) {
    const Sight sight = eyes.look(walker);
    if (canGrab(sight, command.walk.forward)) return true;
    command.walk = towards(sight);
    walker.step(command);
  }
  return false;
}

}  // namespace

GrabEnd grab(const GrabPlace& place, Random& random, PhysicalWalker& walker) {
  const Pose2 pose = walker.pose();
  const Angle way = pose.heading + place.direction;
  walker.bodies().putBall(
      {fieldFromRobot(pose, place.ball), {place.speed * way.cos(), place.speed * way.sin()}});
  if (!approach(place, random, walker)) return walker.fallen() ? GrabEnd::fell : GrabEnd::missed;
  Command command = holdingCommand();
  command.motion = place.motion;
  walker.step(command);
  while (walker.output().status.running != MotionKind::none ||
         walker.state().motion.answered == false) {
    walker.step(command);
    if (walker.fallen()) return GrabEnd::fell;
  }
  command.motion = MotionKind::none;
  for (int i = 0; i < kAfter; ++i) walker.step(command);
  if (walker.fallen()) return GrabEnd::fell;
  return holdsBall(walker) ? GrabEnd::held : GrabEnd::missed;
}

void turnWithBall(double radPerSecond, PhysicalWalker& walker) {
  Command command = holdingCommand();
  command.walk.turn = radPerSecond;
  double turned = 0.0;
  for (int i = 0; i < kApproach && turned < maths::kPi; ++i) {
    const Angle before = walker.pose().heading;
    walker.step(command);
    turned += std::fabs((walker.pose().heading - before).rad());
  }
}

void walkWithBall(double cmPerSecond, double cm, PhysicalWalker& walker) {
  Command command = holdingCommand();
  command.walk.forward = cmPerSecond;
  const Point2<Field> from = walker.pose().position;
  for (int i = 0; i < kApproach && distance(from, walker.pose().position) < cm; ++i)
    walker.step(command);
}

}  // namespace kelpie::learn
