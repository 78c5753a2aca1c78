// SPDX-License-Identifier: Apache-2.0
// A robot's body in the world: servos that follow their targets late, and a body that the feet on
// the ground carry. Kinematic: the body moves so that the feet that stand keep their place (least
// squares), with a seeded slip for each step. It cannot fall over or roll sideways; a randomised
// one leans constantly, its head hangs in the play of its gears, and it goes farther or less far.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "actuator/odometry/FootMotion.h"
#include "robot/body/Legs.h"
#include "robot/body/PlanarMotion.h"
#include "robot/core/Random.h"
#include "robot/core/types/FrameInput.h"
#include "robot/host/world/WorldProtocol.h"
#include "tools/sim/bodies/Backlash.h"
#include "tools/sim/bodies/Bodies.h"
#include "tools/sim/bodies/BodyShape.h"
#include "tools/sim/bodies/CommandQueue.h"
#include "tools/sim/bodies/Randomisation.h"
#include "tools/sim/bodies/Resistance.h"

namespace kelpie::sim {

// What weakly held legs carry of the way that they walk: they give under the weight. Thesis 2004
// section 2.2.4 has about a half of the turn; 2005's odometry calibrations of its walks, weak over
// standard, 0.99, 0.63 and 0.64 (facts-2005 section 6.3).
struct WeakLegParams {
  double below = 0.8;  // of the standard gain
  double forward = 0.97;
  double left = 0.63;
  double turn = 0.5;

  template <int = 0>
  static constexpr auto fields() {
    using P = WeakLegParams;
    return fieldList(field("below", &P::below, "", 0, 1), field("forward", &P::forward, "", 0, 1),
                     field("left", &P::left, "", 0, 1), field("turn", &P::turn, "", 0, 1));
  }
};

// What becomes on carpet of the way that standing feet walk, so that a kinematic robot goes about
// as fast as it is asked to: its walks are calibrated to physical bodies. Fitted by `kelpie
// calibrate fast --seed 11`.
struct GroundParams {
  double forward = 1.273;
  double left = 1.070;
  double turn = 1.379;

  static GroundParams plain() { return {1.0, 1.0, 1.0}; }

  template <int = 0>
  static constexpr auto fields() {
    using P = GroundParams;
    return fieldList(field("forward", &P::forward, "", 0.1, 3), field("left", &P::left, "", 0.1, 3),
                     field("turn", &P::turn, "", 0.1, 3));
  }
};

struct RobotParams {
  double lagTicks = 2.0;         // first-order lag of every joint
  double headRate = 6.5;         // rad/s
  double legRate = 10.0;         // rad/s; the chest push of 72 ms needs about 9
  double jointNoiseSd = 0.0015;  // rad, of the sensed angles
  double contactHeight = 0.4;    // cm; lower feet carry the body
  double slipMean = 0.02;        // share of the way that is lost
  double slipSd = 0.03;          // its spread from step to step
  double driftSd = 0.0006;       // rad per cm of way, from step to step
  GroundParams ground;
  ResistanceParams resistance;
  WeakLegParams weak;

  template <int = 0>
  static constexpr auto fields() {
    using P = RobotParams;
    return fieldList(field("lagTicks", &P::lagTicks, "", 0, 20),
                     field("headRate", &P::headRate, "rad/s", 0.1, 100),
                     field("legRate", &P::legRate, "rad/s", 0.1, 100),
                     field("jointNoiseSd", &P::jointNoiseSd, "rad", 0, 0.1),
                     field("contactHeight", &P::contactHeight, "cm", 0, 3),
                     field("slipMean", &P::slipMean, "", -0.5, 0.5),
                     field("slipSd", &P::slipSd, "", 0, 0.5),
                     field("driftSd", &P::driftSd, "rad/cm", 0, 0.1), field("ground", &P::ground),
                     field("resistance", &P::resistance), field("weak", &P::weak));
  }
};

// A part of the body that the ball can meet: a sphere that moved during the tick.
struct BodySphere {
  FieldPoint3 before;
  FieldPoint3 now;
  double radius = 0.0;
};

// The trunk seen from above, in the robot frame, behind the chest.
constexpr double kTrunkBack = -16.0;
constexpr double kTrunkHalfWidth = 4.5;

using body::PlanarMotion;

class RobotModel {
 public:
  RobotModel(const RobotParams& params, const Pose2& start, std::uint64_t seed,
             const BodyFaults& faults = {});

  // What the agent sent to the effectors.
  void command(const host::AgentReply& reply) { queue_.add(reply); }
  // One tick of 8 ms.
  void tick();
  // Moves the body by force, as an obstacle does. The legs feel it in the next tick.
  void push(Point2<Field> way) {
    place_.pose.position = place_.pose.position + way;
    pushed_ = pushed_ + way;
  }
  void twist(Angle turn) { place_.pose.heading = place_.pose.heading + turn; }
  // From now on the body goes only 1 - share of what the legs walk.
  void hold(double share) { resistance_.hold(share); }
  // Lifts it and sets it down elsewhere, joints as they are; touches nothing on the way. The hand
  // that lets go is felt a moment longer.
  void carry(const Pose2& pose);
  // From now on a hand round the trunk holds it so high that its legs find no ground; 0 = no more.
  void lift(double height) { lifted_ = height; }
  void touch(const Touch& touch) { touch_ = touch; }
  // What fingers press now, and the hand that lifts.
  Touch touched() const;

  const BodyPlace& place() const { return place_; }
  const BodyPlace& placeBefore() const { return before_; }
  const JointAngles& target() const { return queue_.target(); }
  // Where the motors are: as place().joints but for the play of the head.
  const JointAngles& motors() const { return motors_; }
  const BodyFaults& faults() const { return faults_; }
  const JointAngles& sensed() const { return sensed_; }
  double legGain() const { return queue_.legGain(); }  // over the standard one
  const std::array<double, kJointCount>& dutyNoise() const { return dutyNoise_; }
  const std::array<bool, kLegCount>& onGround() const { return onGround_; }
  std::array<BodySphere, 9> spheres() const;
  CommandQueue& queue() { return queue_; }

 private:
  void moveJoints();
  double slowed(std::size_t joint) const;  // share of its movement that a joint keeps
  void senseJoints();
  void moveBody();
  std::array<bool, kLegCount> standingLegs() const;
  PlanarMotion rolled();
  PlanarMotion given(const PlanarMotion& walked) const;
  PlanarMotion onCarpet(const PlanarMotion& walked) const;
  void drawSlip(const std::array<bool, kLegCount>& standing);

  RobotParams params_;
  Random random_;
  Resistance resistance_;
  BodyFaults faults_;
  Backlash neck_;
  BodyPlace place_;
  BodyPlace before_;
  JointAngles motors_;
  CommandQueue queue_;
  JointAngles sensed_;
  actuator::FootMotionState rolling_;
  std::array<bool, kLegCount> onGround_{};
  Point2<Field> walked_;  // by itself in the last tick
  Point2<Field> pushed_;  // and by others since
  std::array<double, kJointCount> dutyNoise_{};
  double slipForward_ = 0.0;
  double lateralSlip_ = 0.0;
  double slipTurn_ = 0.0;
  double drift_ = 0.0;
  double lifted_ = 0.0;  // cm
  int handTicks_ = 0;    // that a hand is still felt
  Touch touch_;
};

}  // namespace kelpie::sim
