// SPDX-License-Identifier: Apache-2.0
// How far and where a kick sends the ball, on one physical model: the robot stands or holds the
// ball, plays the motion, and the ball rolls out. What comes before the kick is simulated once;
// each trial goes on from a copy of it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/learn/walk/WalkTrial.h"
#include "tools/sim/kicks/KickMap.h"

namespace kelpie::learn {

// What is wanted of a kick, and from where. Directions are left of straight ahead.
struct KickAim {
  MotionKind motion = MotionKind::none;
  bool held = false;        // the ball is held under the chin, else it lies free
  Point2<Robot> ball;       // cm from the neck base: where it lies, before it is held
  double scatter = 1.2;     // cm, to each side of there
  double distance = 100.0;  // cm, what counts as 1
  Angle min;
  Angle max;
  int frames = 20;  // of 1/30 s at most
};

// The kicks of actuator/data/motions; the one to the right of a pair is the mirrored left one.
const std::vector<KickAim>& kicks();
const KickAim* findKick(MotionKind motion);
using sim::mirrored;
KickAim mirrored(const KickAim& aim);

// The one of a motion as it is: a free ball lies where the motion wants it.
KickAim aimOf(const KickAim& aim, const actuator::MotionData& motion);

// A robot about to kick.
struct KickStart {
  std::unique_ptr<actuator::ActuatorParams> params;
  std::unique_ptr<PhysicalWalker> walker;
  Point2<Field> ball;
  Pose2 pose;
  sim::PhysicalBallParams roll;
};
// What happens to the robot before it kicks: nothing; another robot comes from the front and
// pushes, from half a second before; it turns with a held ball, as players do, and has just
// stopped.
enum class BeforeKick : std::uint8_t { rests, pushed, turned };

// The ball lies up to the scatter beside its place, as the seed has it.
KickStart beforeKick(const KickAim& aim, const sim::PhysicsParams& model, std::uint64_t seed,
                     BeforeKick before = BeforeKick::rests);

// Stands, its ball nowhere near; then the same instant with a ball that lies there at rest, or as
// near as the robot's body lets it.
KickStart standingStart(const sim::PhysicsParams& model, std::uint64_t seed);
KickStart withBallAt(Point2<Robot> place, const KickStart& standing);
// Goes on from there walking, for so many messages.
KickStart walkingStart(const KickStart& standing, const WalkRequest& walk, int messages);
// The same instant with a ball put there.
KickStart withBallJustAt(Point2<Robot> place, const KickStart& start);

// Where a ball lies still at last, when nothing stops it.
Point2<Field> restingPlace(const sim::Ball& ball, const sim::PhysicalBallParams& roll);

struct Kicked {
  double distance = 0.0;  // cm, until the ball lies still
  Angle direction;        // of its way
  bool fell = false;      // or its physics failed
  bool left = true;       // a held ball is no longer between the legs
  Walked way;             // of the robot, until it stands again
};
Kicked tryKick(const actuator::MotionData& motion, MotionKind kind, const KickStart& start);

}  // namespace kelpie::learn
