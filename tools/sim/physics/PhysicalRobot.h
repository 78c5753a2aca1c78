// SPDX-License-Identifier: Apache-2.0
// One ERS-7 in the engine: targets in, what its body does and feels out. Keeps only where in the
// engine's arrays the robot is; its state is the engine's.
#pragma once

#include <array>

#include "robot/core/types/Joints.h"
#include "tools/sim/bodies/BodyShape.h"
#include "tools/sim/physics/Engine.h"
#include "tools/sim/physics/Mjcf.h"

namespace kelpie::sim {

// What its sensors take from the body itself, without noise.
struct RawFeeling {
  std::array<double, kJointCount> duty{};  // -1 to 1, what the servo gives of its stall torque
  std::array<double, 3> acceleration{};    // cm/s2: forward, left, up
  std::array<bool, kLegCount> paw{};
  bool chin = false;
};

class PhysicalRobot {
 public:
  PhysicalRobot(const Engine& engine, std::size_t number);

  // Puts it there, upright and at rest, its lowest point on the carpet.
  void place(const Pose2& pose, const JointAngles& joints, Engine& engine) const;
  // Where the servos shall go, and how strong they are beside the standard: 0 lets a joint loose.
  void command(const JointAngles& target, const std::array<double, kJointCount>& gain,
               const ServoParams& servo, Engine& engine) const;

  JointAngles joints(const Engine& engine) const;
  // The body as camera and drawings want it; the neck has no play here.
  BodyPlace bodyPlace(const Engine& engine) const;
  RawFeeling feeling(const ServoParams& servo, const Engine& engine) const;
  double pushOnBall(const Engine& engine) const;  // N, of all its parts

  // Of the trunk, m/s and rad/s: three along the field's axes, three about the body's own.
  const mjtNum* velocity(const Engine& engine) const { return engine.data().qvel + freeDof_; }
  // Moves it by hand, as far as that.
  void shift(Point2<Field> way, Angle turn, Engine& engine) const;

  int trunk() const { return trunk_; }
  bool owns(int geom) const { return geom >= firstGeom_ && geom <= lastGeom_; }

 private:
  int trunk_ = 0;
  int freeQpos_ = 0;
  int freeDof_ = 0;
  int accelerometer_ = 0;  // first of its three in sensordata
  int firstGeom_ = 0;
  int lastGeom_ = 0;
  std::array<int, kServoCount> qpos_{};
  std::array<int, kServoCount> actuator_{};
  std::array<int, kLegCount> paw_{};
  int chin_ = 0;
  int jaw_ = 0;
  int ball_ = 0;
};

}  // namespace kelpie::sim
