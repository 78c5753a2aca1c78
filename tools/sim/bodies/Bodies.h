// SPDX-License-Identifier: Apache-2.0
// The robots of a world and the ball, moved by ticks of 8 ms: physical ones (physics/) or kinematic
// ones (`--fast`). All that the world around them, referee, camera, sensors, interventions, needs
// of them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "robot/core/Expected.h"
#include "robot/host/world/WorldProtocol.h"
#include "tools/sim/bodies/BodyShape.h"
#include "tools/sim/world/Ball.h"

namespace kelpie::sim {

// The chest ahead of the neck base, in the robot frame (data/robot/geometry.csv).
constexpr double kChestAhead = 1.8;

// What somebody's fingers press.
struct Touch {
  double head = 0.0;           // 0 to kHardestTouch
  std::array<bool, 3> back{};  // front, middle, rear
  bool chin = false;
};
constexpr double kHardestTouch = 80.0;  // of the head's sensor (openr.md 5.6)

// What a robot's sensors take from its body itself.
struct BodyFeeling {
  JointAngles joints;                      // as sensed
  std::array<double, kJointCount> duty{};  // of the motors, -1 to 1
  std::array<double, 3> acceleration{};    // cm/s2: forward, left, up; without the sensor's noise
  std::array<bool, kLegCount> paw{};
  Touch touch;
};

// The nearest place that robots may walk to: 60 cm beyond the carpet the room ends.
constexpr double kCapacity = 60.0;
inline Point2<Field> nearestWalkable(const body::FieldDescription& field, Point2<Field> p) {
  const double side = field.sideFringe + kCapacity;
  const double end = field.endFringe + kCapacity;
  return {maths::clamp(p.x, -side, field.width + side),
          maths::clamp(p.y, -end, field.length + end)};
}

class Bodies {
 public:
  virtual ~Bodies() = default;

  virtual std::size_t count() const = 0;
  // What an agent sent to the effectors.
  virtual void command(std::size_t robot, const host::AgentReply& reply) = 0;
  // Command vectors whose output ended since the last call, and those still to come.
  virtual std::uint32_t takeVectorsDone(std::size_t robot) = 0;
  virtual std::size_t vectorsWaiting(std::size_t robot) = 0;

  // One tick; or what ends the match, in one line.
  virtual Status tick() = 0;

  virtual BodyPlace place(std::size_t robot) const = 0;
  virtual BodyFeeling feel(std::size_t robot) = 0;
  virtual std::array<bool, kLegCount> onGround(std::size_t robot) const = 0;  // which paws
  virtual Ball ball() const = 0;
  // Who moved the ball in the last tick, by walking into it, holding it or with a kick; of several
  // the one who gave it the most.
  virtual std::optional<std::size_t> ballToucher() const = 0;
  virtual void putBall(const Ball& ball) = 0;

  // Interventions, as World has them; places and shares have been checked.
  virtual void carry(std::size_t robot, const Pose2& pose) = 0;
  virtual void hold(std::size_t robot, double share) = 0;
  virtual void shove(std::size_t robot, Point2<Field> way, Angle turn) = 0;
  virtual void lift(std::size_t robot, double height) = 0;
  virtual void touch(std::size_t robot, const Touch& touch) = 0;
  // All that stands on the field from now on. Error: more than there is room for.
  virtual Status setObstacles(const std::vector<Obstacle>& obstacles) = 0;
};

}  // namespace kelpie::sim
