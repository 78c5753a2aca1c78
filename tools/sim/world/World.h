// SPDX-License-Identifier: Apache-2.0
// The simulated world in one process, without sockets: robots, ball, referee and each robot's
// camera, in ticks of 8 ms. Everything random comes from the seed: the same seed and the same
// commands give the same match, byte for byte.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "robot/core/Expected.h"
#include "robot/host/world/WorldProtocol.h"
#include "tools/sim/bodies/Bodies.h"
#include "tools/sim/bodies/LateJoints.h"
#include "tools/sim/bodies/Past.h"
#include "tools/sim/bodies/Randomisation.h"
#include "tools/sim/bodies/RobotModel.h"
#include "tools/sim/bodies/Sensors.h"
#include "tools/sim/camera/Camera.h"
#include "tools/sim/camera/OuterWall.h"
#include "tools/sim/physics/PhysicalBodies.h"
#include "tools/sim/referee/Referee.h"
#include "tools/sim/staging/Intervention.h"
#include "tools/sim/world/Ball.h"
#include "tools/sim/world/Radio.h"
#include "tools/sim/world/Setup.h"
#include "tools/sim/world/Truth.h"

namespace kelpie::sim {

struct WorldParams {
  CameraParams camera;
  bool fast = true;  // kinematic bodies in place of physical ones
  RobotParams robot;
  PhysicsParams physics;
  PhysicalSensorParams physicalSensors;
  BallParams ball;
  SensorParams sensors;
  RefereeParams referee;
  RadioParams radio;
  ShineParams shine;
  RandomisationParams randomised;  // no field of the list below: its truth has a topic of its own
  bool rolling = true;             // each image column is exposed at its own time
  bool spectators = true;          // people and coloured things around the field
  bool ownLegs = true;             // a robot can see its own front legs

  template <int = 0>
  static constexpr auto fields() {
    using P = WorldParams;
    return fieldList(
        field("camera", &P::camera), field("fast", &P::fast), field("robot", &P::robot),
        field("physics", &P::physics), field("physicalSensors", &P::physicalSensors),
        field("ball", &P::ball), field("sensors", &P::sensors), field("referee", &P::referee),
        field("radio", &P::radio), field("shine", &P::shine), field("rolling", &P::rolling),
        field("spectators", &P::spectators), field("ownLegs", &P::ownLegs));
  }
};

class World {
 public:
  World(const WorldParams& params, const body::FieldDescription& field, const Setup& setup,
        std::uint64_t seed);

  // One tick of 8 ms; or, from then on always, what ended the match in one line.
  Status tick();
  // Somebody carries a robot to another place. No image shows the way; its back feels the hand for
  // 0.2 s. Refuses a robot that is not
  // there and a pose that is not finite or off the ground that robots may walk on.
  Status carry(std::size_t robot, const Pose2& pose);
  // What a person does to the match while it is played.
  Intervention& interventions() { return interventions_; }
  // Somebody holds a robot's trunk: it goes only 1 - share of what its legs walk, until the next
  // call. Refuses shares outside 0 to 1.
  Status hold(std::size_t robot, double share);
  // Somebody pushes and turns it, as far as that in one tick.
  Status shove(std::size_t robot, Point2<Field> way, Angle turn);
  // Somebody lifts it by the trunk, so high over where it stood, until the next call; 0 sets it
  // down. Its legs find no ground, and the middle of its back feels the hand. Others still walk
  // round it. Refuses what is not from 0 to 15 cm.
  Status lift(std::size_t robot, double height);
  // Fingers press its sensors so until the next call. Refuses a pressure off the sensor's range.
  Status touch(std::size_t robot, const Touch& touch);
  // Somebody changes what stands round the field, as between the stages of the 2004 challenge. One
  // outer wall fits.
  Status putUp(const OuterWall& wall);
  Status takeLandmarksAway();  // no beacons, goals covered with white
  std::uint32_t ticks() const { return ticks_; }
  TimeUs time() const { return {static_cast<std::int64_t>(ticks_) * kTickUs}; }
  bool finished() const { return referee_.finished(); }

  std::size_t robotCount() const { return players_.size(); }
  Bodies& bodies() { return *bodies_; }
  // Sensor frames of the last four ticks, oldest first.
  const std::array<SensorFrame, kTicksPerMessage>& sensors(std::size_t robot) const {
    return sensors_[robot];
  }
  double batteryCurrent(std::size_t robot) const {
    return sim::batteryCurrent(sensors_[robot], params_.sensors, !params_.fast);
  }
  // Share of a full battery that is left.
  double batteryCharge(std::size_t robot) const { return charge_[robot]; }
  // The image whose exposure of 1/30 s ends at `end`; ticks() must have reached it, by at most one
  // tick.
  void render(std::size_t robot, TimeUs end, Image& image) { render(robot, past_, end, image); }
  // The camera's place on the field for each column of that image, as it really is.
  ColumnCameras cameras(std::size_t robot, TimeUs end) const { return cameras(robot, past_, end); }
  // The same from a copy of the past that reaches it. Different robots' images may be rendered so
  // at the same time, and while the world ticks on.
  const Past& past() const { return past_; }
  void render(std::size_t robot, const Past& past, TimeUs end, Image& image);

  // A robot sends a packet to all others; those that have reached it by now.
  void send(std::size_t robot, const RadioPacket& packet);
  RadioPackets takePackets(std::size_t robot) { return radio_.take(robot, time()); }
  bool expectsPackets(std::size_t robot) const { return radio_.expects(robot); }

  // What the game controller broadcasts, and what that robot makes of it.
  net::GameControlData control() const { return referee_.control(); }
  GameState gameFor(std::size_t robot) const;
  // A game controller outside has sent this; it rules with RefereeParams::controlled.
  void hear(const net::GameControlData& control) { referee_.hear(control); }
  TruthFrame truth(TimeUs time) const;
  // What was drawn of it when it is randomised; for logs.
  const RandomisedWorld& randomised() const { return randomised_; }
  bool isRandomised() const {
    return params_.randomised.seed != 0 || !params_.randomised.lean.level();
  }
  Ball ball() const { return bodies_->ball(); }
  void putBall(const Ball& ball) { bodies_->putBall(ball); }
  const Score& score() const { return referee_.score(); }
  // Of referee and interventions, in the order of time.
  std::vector<MatchEvent> takeEvents();

 private:
  struct Eye {
    Camera camera;
    Random random;
    Scene scene;  // its own, so that no robot's image waits for another's
  };
  ColumnCameras cameras(std::size_t robot, const Past& past, TimeUs end) const;
  double ticksAt(std::size_t robot, TimeUs end, double share) const;
  void buildBodies(std::uint64_t seed);
  MatchScene matchScene() const;
  void senseAll();
  void throwBalls();
  void obey(const Verdict& verdict);
  // Of interventions and referee, obeyed.
  std::array<Verdict, 2> judge();

  WorldParams params_;
  body::FieldDescription field_;
  RandomisedWorld randomised_;
  std::vector<Obstacle> obstacles_;
  std::vector<Player> players_;
  std::vector<BallThrow> throws_;
  std::size_t thrown_ = 0;  // of them
  std::vector<std::uint64_t> shine_;
  std::unique_ptr<Bodies> bodies_;
  std::vector<std::array<SensorFrame, kTicksPerMessage>> sensors_;
  std::vector<Random> sensorRandom_;
  std::vector<LateJoints> joints_;
  std::vector<double> charge_;
  std::vector<std::unique_ptr<Eye>> eyes_;
  Referee referee_;
  Intervention interventions_;
  Radio radio_;
  Past past_;
  std::uint32_t ticks_ = 0;
  std::string fault_;
};

}  // namespace kelpie::sim
