// SPDX-License-Identifier: Apache-2.0
// What a kinematic world, which knows no blows, makes of grabs and kicks. A ball between the paws
// of a robot whose head is in the pose that holds one goes where the robot goes. A robot whose legs
// are commanded into the last key frame of a kick (actuator/data/motions) sends the ball as the
// kick map has it (KickTable), from where it lies or from the hold, by a robot that stands or
// walks. All as seen from where the motion began: its legs carry a kinematic body by up to 15 cm
// and 45 deg to and fro, which a ball knows nothing of. Knows no other motions than those that are
// compiled in.
#pragma once

#include <optional>
#include <vector>

#include "actuator/motion/MotionData.h"
#include "robot/core/Random.h"
#include "tools/sim/bodies/RobotModel.h"
#include "tools/sim/world/Ball.h"

namespace kelpie::sim {

// The speed with which a ball leaves to roll so far.
double speedToRoll(double distance, const BallParams& params);

// The head that holds a ball, by where it is commanded.
bool holdingPose(const JointAngles& target);

class FastKicks {
 public:
  FastKicks(const BallParams& ball, std::uint64_t seed) : ball_(ball), random_(seed ^ 0x61c45ULL) {}

  // One tick of one robot. True: what it does with the ball is settled, no part of it touches it.
  bool tick(std::size_t robot, const RobotModel& body, Ball& ball);
  // A hand takes the ball, or the robot.
  void drop(std::size_t robot) {
    if (robot < grips_.size()) grips_[robot].holds = false;
  }
  bool holds(std::size_t robot) const { return robot < grips_.size() && grips_[robot].holds; }
  // Who holds the ball.
  std::optional<std::size_t> holder() const {
    for (std::size_t i = 0; i < grips_.size(); ++i)
      if (grips_[i].holds) return i;
    return std::nullopt;
  }

 private:
  struct Grip {
    bool holds = false;
    bool kicked = false;  // by the motion that is played
    double stands = 1.0;  // s, since it last walked before that motion
    Pose2 start;          // of the robot, before that motion
    Point2<Robot> place;  // of a held ball
    JointAngles target;   // of the tick before
  };
  bool hold(const RobotModel& body, Grip& grip, Ball& ball) const;
  void kick(MotionKind kind, Grip& grip, Ball& ball);

  BallParams ball_;
  Random random_;
  std::vector<Grip> grips_;
};

}  // namespace kelpie::sim
