// SPDX-License-Identifier: Apache-2.0
// The physical robots and ball as the world needs them: servos get what agents sent, sensors get
// what the bodies feel with their noise. A hand holds a trunk by a spring; the tail, which carries
// nothing, goes where it is commanded at once.
#pragma once

#include <optional>
#include <vector>

#include "robot/core/Random.h"
#include "tools/sim/bodies/Backlash.h"
#include "tools/sim/bodies/Bodies.h"
#include "tools/sim/bodies/CommandQueue.h"
#include "tools/sim/bodies/Randomisation.h"
#include "tools/sim/physics/Physics.h"

namespace kelpie::sim {

struct PhysicalSensorParams {
  double jointNoiseSd = 0.0015;  // rad, of the sensed angles
  double dutyNoise = 0.03;       // sd of every motor's duty

  template <int = 0>
  static constexpr auto fields() {
    using P = PhysicalSensorParams;
    return fieldList(field("jointNoiseSd", &P::jointNoiseSd, "rad", 0, 0.1),
                     field("dutyNoise", &P::dutyNoise, "", 0, 1));
  }
};

// One robot as it is put down.
struct PhysicalStart {
  Pose2 pose;
  PhysicsParams params;
  BodyFaults faults;
  std::uint64_t seed = 0;
};

class PhysicalBodies : public Bodies {
 public:
  static Expected<std::unique_ptr<PhysicalBodies>> build(const body::FieldDescription& field,
                                                         const std::vector<PhysicalStart>& robots,
                                                         const PhysicsParams& world,
                                                         const PhysicalSensorParams& sensors);

  std::size_t count() const override { return robots_.size(); }
  void command(std::size_t robot, const host::AgentReply& reply) override {
    robots_[robot].queue.add(reply);
  }
  std::uint32_t takeVectorsDone(std::size_t robot) override {
    return robots_[robot].queue.takeVectorsDone();
  }
  std::size_t vectorsWaiting(std::size_t robot) override {
    return robots_[robot].queue.vectorsWaiting();
  }
  Status tick() override;
  BodyPlace place(std::size_t robot) const override { return robots_[robot].place; }
  BodyFeeling feel(std::size_t robot) override;
  std::array<bool, kLegCount> onGround(std::size_t robot) const override;
  Ball ball() const override { return physics_.ball(); }
  std::optional<std::size_t> ballToucher() const override { return physics_.ballToucher(); }
  void putBall(const Ball& ball) override { physics_.putBall(ball); }
  void carry(std::size_t robot, const Pose2& pose) override;
  void hold(std::size_t robot, double share) override;
  void shove(std::size_t robot, Point2<Field> way, Angle turn) override;
  void lift(std::size_t robot, double height) override;
  void touch(std::size_t robot, const Touch& touch) override { robots_[robot].touch = touch; }
  Status setObstacles(const std::vector<Obstacle>& obstacles) override {
    return physics_.setObstacles(obstacles);
  }

  Physics& physics() { return physics_; }

 private:
  struct Robot {
    CommandQueue queue;
    Backlash neck;
    BodyFaults faults;
    Random random;
    BodyPlace place;
    Touch touch;
    double held = 0.0;
    double lifted = 0.0;        // cm
    Pose2 anchor;               // where a hand took it
    double anchorHeight = 0.0;  // m
    int handTicks = 0;
    std::array<double, kJointCount> driven{};  // rad, the far side of each gear's play
  };
  JointAngles throughGears(std::size_t i);
  PhysicalBodies(Physics physics, const PhysicalSensorParams& sensors)
      : physics_(std::move(physics)), sensors_(sensors) {}
  void drive(std::size_t i);
  void pull(std::size_t i);
  void readPlace(std::size_t i);

  Physics physics_;
  PhysicalSensorParams sensors_;
  std::vector<Robot> robots_;
};

}  // namespace kelpie::sim
