// SPDX-License-Identifier: Apache-2.0
// A robot that walks and looks, from pixels: the world's side, with the truth as a View, and the
// robot's side, which is the agent's frame loop but for the behaviours. The walk is kinematic: no
// legs move, and the accelerometer feels no steps. A walk may be spoilt in ways that the robot is
// not told of.
#pragma once

#include <functional>
#include <memory>

#include "gps/GpsState.h"
#include "robot/agent/AgentConfig.h"
#include "tools/experiments/harness/Statistics.h"
#include "tools/experiments/views/Objects.h"
#include "tools/experiments/views/View.h"
#include "tools/sim/world/Observer.h"
#include "vision/Vision.h"

namespace kelpie::experiments {

// What is wrong with a walk. Angles are in degrees, light is a factor.
struct Spoil {
  double jointsLate = 0.0;      // frames that joint angles are old
  double imageLate = 0.0;       // frames that images are old
  double odometryScale = 1.0;   // of the way that is told, ahead and aside
  double odometryTurn = 0.0;    // deg a frame that are told too much, to the left
  double light = 1.0;           // of all three channels
  double colour = 1.0;          // of both colour channels besides
  double landmarkColour = 1.0;  // of those of yellow, blue and pink, which become as much brighter
  double noiseSd = 0.0;         // levels, of every channel of a pixel
  double beaconAside = 0.0;     // cm along the line that the one nearest to the walk's end is off
  bool beaconAbsent = false;
  double swayTilt = 0.0;  // deg, amplitude
  double swayRoll = 0.0;
  double swayHz = 2.2;
  double pan = 0.0;  // deg that the head looks farther left than its joint says
};

class PixelWalk {
 public:
  static constexpr int kFrames = 240;

  PixelWalk(const agent::AgentConfig& config, const sim::RandomisationParams& randomised,
            std::uint64_t seed, const Spoil& spoil = {});

  // `lag`: what the robot believes that its images are older than their stamps, s; it gets the
  // joints of that much earlier.
  View& next(int frame, double lag);
  // As it stands there: without a beacon that is absent, one that is off its place where it is.
  const body::FieldDescription& field() const { return field_; }

 private:
  static sim::TruePose startOf(const body::FieldDescription& field, Random& random);
  sim::FieldCamera exposed(int frame, double turn, double late);
  JointAngles neck(double frame, double panRate) const;
  sim::Lean leanAt(double frame) const;
  void sense(int frame, double lag);

  Spoil spoil_;
  body::FieldDescription field_;
  View view_;
  Random random_;
  sim::Observer walker_;
  Random sensorRandom_;
  Random spoilRandom_;
  std::unique_ptr<sim::Camera> camera_;
};

class Believer {
 public:
  explicit Believer(const agent::AgentConfig& config);

  // What the robot tells itself for the next frame goes into the input, as AgentLoops does.
  void step(FrameInput& input);
  double lag() const { return world_.imageLag.seconds; }  // s
  const Percepts& seen() const { return seen_; }
  const WorldModel& world() const { return world_; }

 private:
  const agent::AgentConfig& config_;
  std::unique_ptr<vision::VisionState> vision_;
  std::unique_ptr<gps::GpsState> gps_;
  Percepts seen_;
  WorldModel world_;
};

// Walks it all; `each(frame, view, robot)` is called after every frame.
using AfterFrame = std::function<void(int frame, const View& view, const Believer& robot)>;
void walkThrough(const agent::AgentConfig& config, PixelWalk& walking, const AfterFrame& each);

// Of beacons and goals that show, those that are among the percepts, and how many percepts are of
// nothing that shows.
struct Recognised {
  Share seen;
  int falsePercepts = 0;

  void compare(const std::vector<TrueObject>& objects, const Percepts& percepts);

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("seen", &Recognised::seen),
                     field("falsePercepts", &Recognised::falsePercepts));
  }
};

}  // namespace kelpie::experiments
