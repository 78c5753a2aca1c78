// SPDX-License-Identifier: Apache-2.0
// What passes the motion loop: sensor frames and the current Command in; joint targets, odometry
// and stances out. One message holds four ticks of 8 ms, as an OPEN-R sensor vector does.
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/Time.h"
#include "robot/core/types/Command.h"
#include "robot/core/types/Joints.h"

namespace kelpie {

// How the body stands: height of the front shoulder axis above the ground and how far the body
// leans forward. Positive tilt = nose down (the hind legs are longer: default 14.25 deg).
struct Stance {
  double shoulderHeight = 10.0;
  Angle bodyTilt;
  Angle bodyRoll;  // left side up positive

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("shoulderHeight", &Stance::shoulderHeight, "cm", 0, 30),
                     field("bodyTilt", &Stance::bodyTilt, "rad", -90, 90),
                     field("bodyRoll", &Stance::bodyRoll, "rad", -90, 90));
  }
};

// Everything but the camera that the robot senses in one 8 ms tick.
struct SensorFrame {
  JointAngles joints;
  std::array<double, kJointCount> duty{};  // motor duty, -1..1
  double headNearDistance = 50.0;
  double headFarDistance = 150.0;
  double chestDistance = 90.0;
  std::array<double, 3> acceleration{};  // forward, left, up; up reads +981 standing still
  std::array<bool, kLegCount> paw{};
  bool chin = false;
  double headTouch = 0.0;
  std::array<bool, 3> back{};  // front, middle, rear

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("joints", &SensorFrame::joints), field("duty", &SensorFrame::duty, "", -1, 1),
        field("headNearDistance", &SensorFrame::headNearDistance, "cm", 0, 60),
        field("headFarDistance", &SensorFrame::headFarDistance, "cm", 0, 200),
        field("chestDistance", &SensorFrame::chestDistance, "cm", 0, 100),
        field("acceleration", &SensorFrame::acceleration, "cm/s2", -4000, 4000),
        field("paw", &SensorFrame::paw), field("chin", &SensorFrame::chin),
        field("headTouch", &SensorFrame::headTouch, "", 0, 100), field("back", &SensorFrame::back));
  }
};

// What the battery said last.
struct Battery {
  double current = 0.0;  // drawn, mA
  double charge = 1.0;   // share of a full one that is left

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("current", &Battery::current, "mA", 0, 2e4),
                     field("charge", &Battery::charge, "", 0, 1));
  }
};

// Variances of an odometry step; all 0 when the actuator does not know.
struct OdometryVariance {
  double forward = 0.0;  // cm2
  double left = 0.0;     // cm2
  double turn = 0.0;     // rad2

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("forward", &OdometryVariance::forward, "cm2", 0, 1e4),
                     field("left", &OdometryVariance::left, "cm2", 0, 1e4),
                     field("turn", &OdometryVariance::turn, "rad2", 0, 10));
  }
};

// How far the robot frame moved on the ground: along and across its own axis, then turned.
struct Odometry {
  double forward = 0.0;
  double left = 0.0;
  Angle turn;
  OdometryVariance variance;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("forward", &Odometry::forward, "cm", -100, 100),
                     field("left", &Odometry::left, "cm", -100, 100),
                     field("turn", &Odometry::turn, "rad", -180, 180),
                     field("variance", &Odometry::variance));
  }
};

// Why a robot does not play. It lies down for the pause switch, a battery that is nearly empty or
// gives too much current, heat, a fan that stands still, a joint that does not follow, and when no
// image has come for a while. It stays as it was found while its motors have no power (the robot
// cuts it when a joint is jammed), while they are powered up one after the other, until a person
// has asked it to stand, and while it is lifted off the ground.
enum class Rest : std::uint8_t {
  none,
  paused,
  batteryLow,
  powerless,
  blind,
  starting,
  unasked,
  lifted,
  overCurrent,
  hot,
  fan,
  jointStuck,
};
constexpr std::uint8_t kRestCount = 12;

constexpr bool staysAsFound(Rest rest) {
  return rest == Rest::powerless || rest == Rest::starting || rest == Rest::unasked ||
         rest == Rest::lifted;
}

struct MotionInput {
  TimeUs time;  // of the last tick in the message
  std::array<SensorFrame, kTicksPerMessage> sensors{};
  double batteryCurrent = 0.0;  // drawn, mA
  double batteryCharge = 1.0;   // share of a full one that is left
  Command command;
  Rest rest = Rest::none;           // not none: lie or stay, whatever the command asks of the legs
  std::uint32_t held = kAllJoints;  // bit i: joint i has a gain, so that its motor holds it

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("time", &MotionInput::time, "us"),
                     field("sensors", &MotionInput::sensors),
                     field("batteryCurrent", &MotionInput::batteryCurrent, "mA", 0, 2e4),
                     field("batteryCharge", &MotionInput::batteryCharge, "", 0, 1),
                     field("command", &MotionInput::command),
                     field("rest", &MotionInput::rest, "", 0, kRestCount - 1),
                     field("held", &MotionInput::held));
  }
};

struct JointFrame {
  JointAngles target;
  std::uint32_t leds = 0;
  EarRequest ears;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("target", &JointFrame::target), field("leds", &JointFrame::leds),
                     field("ears", &JointFrame::ears));
  }
};

// Where a robot lies that has fallen: on its nose or belly, its back, its left or right side.
enum class FallSide : std::uint8_t { none, front, back, left, right };
constexpr std::uint8_t kFallSideCount = 5;

// What the body feels of the world: from motor duty, joint speed, accelerometer, paws, chin, chest.
struct Feeling {
  double current = 0.0;  // mean over the last step of the rotators' current, share of the greatest;
                         // 0 while not walking
  double load = 0.0;     // that current beyond what the same walk takes on free ground
  bool stuck = false;
  FallSide fallen = FallSide::none;
  bool lifted = false;               // somebody carries it, or has not let go for long
  bool ballHeld = false;             // between chin, chest and forelegs
  std::array<bool, 2> pawBlocked{};  // left and right front paw pressed in the air

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("current", &Feeling::current, "", 0, 1),
                     field("load", &Feeling::load, "", -1, 1), field("stuck", &Feeling::stuck),
                     field("fallen", &Feeling::fallen, "", 0, kFallSideCount - 1),
                     field("lifted", &Feeling::lifted), field("ballHeld", &Feeling::ballHeld),
                     field("pawBlocked", &Feeling::pawBlocked));
  }
};

// What the actuator is doing, for the behaviours.
struct MotionStatus {
  MotionKind running = MotionKind::none;  // the special motion under way
  double secondsLeft = 0.0;
  bool ready = false;    // it stands; false on the way up
  bool lying = false;    // it rests, and has lain down
  double effort = 0.0;   // mean over the last step of the hardest working leg joint's duty, 0..1;
                         // 0 while not walking (thesis 2004 section 2.2.4)
  bool lowGain = false;  // the leg joints are held weakly, to spare the battery
  double legGain = 1.0;  // else this share of their standard gain, as the motion wants it for the
                         // ticks that are played next
  Feeling feeling;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("running", &MotionStatus::running, "", 0, kMotionKindCount - 1),
                     field("secondsLeft", &MotionStatus::secondsLeft, "s", 0, 10),
                     field("ready", &MotionStatus::ready), field("lying", &MotionStatus::lying),
                     field("effort", &MotionStatus::effort, "", 0, 1),
                     field("lowGain", &MotionStatus::lowGain),
                     field("legGain", &MotionStatus::legGain, "", 0.2, 1),
                     field("feeling", &MotionStatus::feeling));
  }
};

struct MotionOutput {
  std::array<JointFrame, kTicksPerMessage> joints{};
  Odometry odometry;                               // over the message, as commanded and calibrated
  std::array<Stance, kTicksPerMessage> stances{};  // at each tick of the input, by legs and walk
  MotionStatus status;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(
        field("joints", &MotionOutput::joints), field("odometry", &MotionOutput::odometry),
        field("stances", &MotionOutput::stances), field("status", &MotionOutput::status));
  }
};

}  // namespace kelpie
