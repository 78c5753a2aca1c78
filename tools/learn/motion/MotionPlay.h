// SPDX-License-Identifier: Apache-2.0
// Plays one motion on a physical robot that is ready for it, and keeps what happens: whether it
// falls, ends in the stance, how fast the joints go, where the ball gets to; if wanted also the
// shapes of every tick. A fault of the physics counts as a fall.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "tools/learn/walk/PhysicalWalker.h"
#include "tools/sim/physics/Shapes.h"

namespace kelpie::learn {

// A ball that rolls at the robot and comes to a place beside it some time after the motion was
// asked for. It is put down half as long before.
struct RollingBall {
  Point2<Robot> at;      // cm, from where the neck base is as the motion begins
  double speed = 0.0;    // cm/s, as it gets there
  double seconds = 0.6;  // when it gets there
  Angle from;            // where it comes from, left of straight ahead
};

// A robot about to play a motion.
struct MotionStage {
  std::unique_ptr<actuator::ActuatorParams> params;  // the motion in them
  std::unique_ptr<PhysicalWalker> walker;
  Command command;       // the motion included
  Pose2 pose;            // where it stands, or stood before it was laid down
  double height = 0.0;   // cm, of the shoulder in the stance
  bool hasBall = false;  // lying or held; one that rolls comes later
  bool lies = false;     // it begins fallen
  std::optional<RollingBall> rolling;
};
// Stands, no ball about.
MotionStage standingStage(MotionKind kind, const actuator::MotionData& motion,
                          const sim::PhysicsParams& model, std::uint64_t seed);
// Goes on from the same instant, apart.
MotionStage copyOf(const MotionStage& stage);

struct MotionMoment {
  double seconds = 0.0;            // since the motion was asked for
  std::vector<sim::Shape> shapes;  // the ball's the last
};

// cm ahead of where the neck base was: a ball behind it has come by.
constexpr double kBallPassed = -20.0;

struct MotionCourse {
  Pose2 start;
  std::vector<MotionMoment> moments;
  double lean = 0.0;     // deg, the greatest
  double endLean = 0.0;  // deg
  bool fell = false;     // leant by more than 45 deg
  double height = 0.0;   // cm, of the shoulder at the end
  bool upright = false;  // at the end, on its feet
  bool stands = false;   // at the end, as high as in the stance
  Point2<Robot> way;     // from where it began to where it is at the end
  Angle turn;            // so; of one that began lying it means nothing
  Joint fastest = Joint::neckTilt;
  double rate = 0.0;  // deg/s, the fastest joint's greatest
  // Of the ball, from where the robot began.
  Point2<Robot> ballBefore;
  Point2<Robot> ballRests;  // at last
  Point2<Robot> ballVelocity;
  double nearest = 1000.0;  // cm ahead of the neck base
  bool holds = false;
  bool chin = false;  // its switch is pressed at the end
};

// The motion, the return to the stance and 0.7 s more. `moments`: keep the shapes.
MotionCourse playMotion(MotionStage& stage, bool moments);

// Ticks from asking until the servos get the motion's first: two vectors are in flight.
constexpr std::uint32_t kTicksUntilPlayed = 2 * kTicksPerMessage;

}  // namespace kelpie::learn
