// SPDX-License-Identifier: Apache-2.0
// How to walk, as data: where feet stand, how they move, how fast, and what comes of it on carpet.
// One set for each WalkKind. The values are in actuator/data/walks, which `kelpie calibrate
// walk` writes; the defaults here only stand.
#pragma once

#include <array>
#include <cstdint>

#include "actuator/walk/WalkOdometry.h"
#include "actuator/walk/WalkOscillation.h"
#include "robot/core/types/Command.h"

namespace kelpie::actuator {

// The path of a foot through one step (Locus.h).
enum class LocusShape : std::uint8_t { rectangular, elliptical, halfEllipse };
constexpr std::uint8_t kLocusShapeCount = 3;

// How the body is carried and where the feet stand, in the robot frame.
struct StanceParams {
  double shoulderHeight = 10.2;  // cm, of the front shoulder axis
  Angle bodyTilt = Angle::deg(10.5);
  double frontAhead = 2.0;    // front feet ahead of the neck base
  double frontLateral = 9.5;  // and from the middle
  double hindBehind = 13.0;   // hind feet behind the neck base
  double hindLateral = 10.1;

  template <int = 0>
  static constexpr auto fields() {
    using P = StanceParams;
    return fieldList(field("shoulderHeight", &P::shoulderHeight, "cm", 5, 14),
                     field("bodyTilt", &P::bodyTilt, "rad", -10, 40),
                     field("frontAhead", &P::frontAhead, "cm", -5, 10),
                     field("frontLateral", &P::frontLateral, "cm", 4, 12),
                     field("hindBehind", &P::hindBehind, "cm", 4, 20),
                     field("hindLateral", &P::hindLateral, "cm", 4, 12));
  }
};

struct GaitParams {
  LocusShape locus = LocusShape::halfEllipse;
  double halfStepTicks = 22.0;  // each diagonal pair swings once in two half steps
  double frontDuty = 0.5;       // share of the step that a foot is on the ground
  double hindDuty = 0.5;
  double hindPhase = 0.0;   // steps by which hind feet are ahead of their diagonal partners
  double frontLift = 1.5;   // cm
  double hindLift = 1.5;    // cm
  double hindStroke = 1.0;  // stroke of the hind feet over that of the front feet
  double lead = 0.0;        // 0: a swing begins and ends at rest; 1: as fast as the ground moves
  double acceleration = 90.0;
  double turnAcceleration = 9.0;

  template <int = 0>
  static constexpr auto fields() {
    using P = GaitParams;
    return fieldList(field("locus", &P::locus, "", 0, kLocusShapeCount - 1),
                     field("halfStepTicks", &P::halfStepTicks, "", 8, 60),
                     field("frontDuty", &P::frontDuty, "", 0.3, 0.8),
                     field("hindDuty", &P::hindDuty, "", 0.3, 0.8),
                     field("hindPhase", &P::hindPhase, "", -0.3, 0.3),
                     field("frontLift", &P::frontLift, "cm", 0.3, 6),
                     field("hindLift", &P::hindLift, "cm", 0.3, 6),
                     field("hindStroke", &P::hindStroke, "", 0.3, 2),
                     field("lead", &P::lead, "", 0, 1),
                     field("acceleration", &P::acceleration, "cm/s2", 10, 1000),
                     field("turnAcceleration", &P::turnAcceleration, "rad/s2", 1, 100));
  }
};

// The greatest speed at which the feet move in each direction alone; two at once share it.
struct StrokeLimits {
  double forward = 33.0;  // cm/s
  double back = 30.0;     // cm/s
  double left = 20.0;     // cm/s, to either side
  double turn = 2.0;      // rad/s, to either side

  template <int = 0>
  static constexpr auto fields() {
    using P = StrokeLimits;
    return fieldList(
        field("forward", &P::forward, "cm/s", 0.1, 150), field("back", &P::back, "cm/s", 0.1, 150),
        field("left", &P::left, "cm/s", 0.1, 100), field("turn", &P::turn, "rad/s", 0.05, 12));
  }
};

// What really comes of the feet's speed: real = scale * s + bend * s * |s|, in each direction.
struct SpeedCurve {
  double scale = 1.0;
  double bend = 0.0;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("scale", &SpeedCurve::scale, "", -30, 30),
                     field("bend", &SpeedCurve::bend, "", -1, 1));
  }
};

// And across: a robot that turns also moves sideways, one that steps sideways also turns (mirrored
// for the other side), and less or more so while it goes forward.
struct WalkCalibration {
  SpeedCurve forward;
  SpeedCurve back;
  SpeedCurve left;
  SpeedCurve turn;
  SpeedCurve leftPerTurn{0.0, 0.0};  // cm a rad
  SpeedCurve turnPerLeft{0.0, 0.0};  // rad a cm
  double forwardPerTurn = 0.0;       // cm a rad, turning to either side
  double forwardPerLeft = 0.0;       // cm a cm, stepping to either side
  double forwardPerLeftTurn = 0.0;   // of the product of both
  double leftPerForwardTurn = 0.0;
  double turnPerForwardLeft = 0.0;

  template <int = 0>
  static constexpr auto fields() {
    using P = WalkCalibration;
    return fieldList(field("forward", &P::forward), field("back", &P::back),
                     field("left", &P::left), field("turn", &P::turn),
                     field("leftPerTurn", &P::leftPerTurn), field("turnPerLeft", &P::turnPerLeft),
                     field("forwardPerTurn", &P::forwardPerTurn, "", -30, 30),
                     field("forwardPerLeft", &P::forwardPerLeft, "", -1, 1),
                     field("forwardPerLeftTurn", &P::forwardPerLeftTurn, "", -1, 1),
                     field("leftPerForwardTurn", &P::leftPerForwardTurn, "", -1, 1),
                     field("turnPerForwardLeft", &P::turnPerForwardLeft, "", -1, 1));
  }
};

// What load (Feeling.h) the walk shows with nothing in its way, for the speed of its feet. It is
// below none: a walk brings about a little more than the weight, the gears and the model of the
// legs explain.
struct FreeLoad {
  double forward = 0.0;  // for a cm/s
  double back = 0.0;     // for a cm/s
  double left = 0.0;     // for a cm/s, to either side
  double turn = 0.0;     // for a rad/s, to either side

  template <int = 0>
  static constexpr auto fields() {
    using P = FreeLoad;
    return fieldList(field("forward", &P::forward, "", -0.1, 0.1),
                     field("back", &P::back, "", -0.1, 0.1), field("left", &P::left, "", -0.1, 0.1),
                     field("turn", &P::turn, "", -1, 1));
  }
};

struct WalkSet {
  StanceParams stance;
  GaitParams gait;
  StrokeLimits max;
  WalkCalibration calibration;
  WalkOdometry odometry = exactOdometry();
  FreeLoad freeLoad;
  WalkOscillation oscillation;

  template <int = 0>
  static constexpr auto fields() {
    using P = WalkSet;
    return fieldList(field("stance", &P::stance), field("gait", &P::gait), field("max", &P::max),
                     field("calibration", &P::calibration), field("odometry", &P::odometry),
                     field("freeLoad", &P::freeLoad), field("oscillation", &P::oscillation));
  }
};

struct WalkSets {
  WalkSet normal;
  WalkSet fast;
  WalkSet turning;
  WalkSet dribble;
  WalkSet back;
  WalkSet low;
  WalkSet weak;

  template <int = 0>
  static constexpr auto fields() {
    using P = WalkSets;
    return fieldList(field("normal", &P::normal), field("fast", &P::fast),
                     field("turning", &P::turning), field("dribble", &P::dribble),
                     field("back", &P::back), field("low", &P::low), field("weak", &P::weak));
  }
};

// A kind that there is not counts as normal.
const WalkSet& walkSet(const WalkSets& sets, WalkKind kind);
WalkSet& walkSet(WalkSets& sets, WalkKind kind);

// Each number of a set on its way to another's, by that share; the locus is that of `to`.
WalkSet mixed(const WalkSet& from, const WalkSet& to, double share);

// Those of actuator/data/walks.
const WalkSets& standardWalks();

}  // namespace kelpie::actuator
