// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/motion/MotionPlay.h"

#include <cmath>

#include "tools/learn/kick/KickTrial.h"
#include "tools/learn/motion/BallInHold.h"
#include "tools/learn/motion/GetUpTrial.h"

namespace kelpie::learn {
namespace {

constexpr double kMessageSeconds = kTickSeconds * kTicksPerMessage;
constexpr double kAfter = 0.7;    // s, after the legs are back
constexpr double kBeside = 60.0;  // cm: beyond, it is put away until it rolls
constexpr double kFallen = 45.0;  // deg
constexpr double kSunk = 1.5;     // cm below the stance that is still standing

// Looks at the robot after every tick.
class Watcher {
 public:
  Watcher(MotionStage& stage, bool moments, MotionCourse& course)
      : walker_(*stage.walker), moments_(moments), course_(course) {
    last_ = walker_.place().joints;
  }

  void look() {
    ++ticks_;
    const double cosine = maths::clamp(uprightness(walker_), -1.0, 1.0);
    course_.endLean = Angle::rad(std::acos(cosine)).deg();
    course_.lean = std::fmax(course_.lean, course_.endLean);
    const JointAngles now = walker_.place().joints;
    for (std::size_t j = 0; j < sim::kServoCount; ++j) {
      const double rate = std::fabs((now.angle[j] - last_.angle[j]).deg()) / kTickSeconds;
      if (rate > course_.rate) course_.fastest = static_cast<Joint>(j);
      course_.rate = std::fmax(course_.rate, rate);
    }
    last_ = now;
    const Point2<Robot> ball = robotFromField(course_.start, walker_.bodies().ball().position);
    if (std::fabs(ball.x) < kBeside) course_.nearest = std::fmin(course_.nearest, ball.y);
    if (moments_) keep();
  }

 private:
  void keep() {
    const sim::Physics& physics = walker_.bodies().physics();
    course_.moments.push_back({ticks_ * kTickSeconds, sim::shapesOf(physics, 0)});
    course_.moments.back().shapes.push_back(sim::ballShape(physics));
  }

  PhysicalWalker& walker_;
  bool moments_;
  MotionCourse& course_;
  JointAngles last_;
  int ticks_ = 0;
};

// dv/dx = -(drag + roll / v), about.
sim::Ball ballOf(const RollingBall& ball, const Pose2& pose, const sim::PhysicalBallParams& roll) {
  const double way = 0.5 * ball.seconds * ball.speed;
  const double brake = roll.drag + 100.0 * roll.roll / ball.speed;
  const Point2<Robot> from = robotPolar(1.0, ball.from);
  const Point2<Robot> place = ball.at + from * way;
  const double speed = ball.speed + brake * way;
  const Point2<Field> origin = fieldFromRobot(pose, {0.0, 0.0});
  return {fieldFromRobot(pose, place), (fieldFromRobot(pose, from) - origin) * -speed};
}

void finish(const MotionStage& stage, MotionCourse& course) {
  PhysicalWalker& walker = *stage.walker;
  const sim::Ball ball = walker.bodies().ball();
  const sim::PhysicalBallParams& roll = walker.bodies().physics().params(0).ball;
  course.ballRests = robotFromField(course.start, restingPlace(ball, roll));
  course.ballVelocity = robotFromField(course.start, course.start.position + ball.velocity);
  course.height = walker.place().stance.shoulderHeight;
  course.way = robotFromField(course.start, walker.pose().position);
  course.turn = walker.pose().heading - course.start.heading;
  course.fell = walker.failed() || course.lean > kFallen;
  course.upright = standsUpright(walker);
  course.stands = course.upright && course.height > stage.height - kSunk;
  course.holds = holdsBall(walker);
  course.chin = walker.bodies().feel(0).touch.chin;
}

}  // namespace

MotionStage standingStage(MotionKind kind, const actuator::MotionData& motion,
                          const sim::PhysicsParams& model, std::uint64_t seed) {
  MotionStage stage;
  stage.params = std::make_unique<actuator::ActuatorParams>();
  stage.params->motions[kind] = motion;
  stage.walker = std::make_unique<PhysicalWalker>(model, *stage.params, seed);
  stage.command.motion = kind;
  stage.pose = stage.walker->pose();
  stage.height = stage.walker->place().stance.shoulderHeight;
  return stage;
}

MotionStage copyOf(const MotionStage& stage) {
  MotionStage copy;
  copy.params = std::make_unique<actuator::ActuatorParams>(*stage.params);
  copy.walker = std::make_unique<PhysicalWalker>(*stage.walker, *copy.params);
  copy.command = stage.command;
  copy.pose = stage.pose;
  copy.height = stage.height;
  copy.hasBall = stage.hasBall;
  copy.lies = stage.lies;
  copy.rolling = stage.rolling;
  return copy;
}

MotionCourse playMotion(MotionStage& stage, bool moments) {
  PhysicalWalker& walker = *stage.walker;
  MotionCourse course;
  course.start = stage.pose;
  course.ballBefore = robotFromField(course.start, walker.bodies().ball().position);
  Watcher watcher(stage, moments, course);
  walker.watch([&watcher] { watcher.look(); });
  const actuator::MotionData& motion = stage.params->motions[stage.command.motion];
  const double ticks = ticksOf(motion) + motion.returnTicks + kTicksUntilPlayed;
  bool rolls = !stage.rolling;
  for (double t = 0.0; t < ticks * kTickSeconds + kAfter; t += kMessageSeconds) {
    if (!rolls && t >= 0.5 * stage.rolling->seconds) {
      const auto& roll = walker.bodies().physics().params(0).ball;
      walker.bodies().putBall(ballOf(*stage.rolling, course.start, roll));
      rolls = true;
    }
    walker.step(stage.command);
  }
  walker.watch({});
  finish(stage, course);
  return course;
}

}  // namespace kelpie::learn
