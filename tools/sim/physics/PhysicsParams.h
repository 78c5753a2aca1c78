// SPDX-License-Identifier: Apache-2.0
// What a physical ERS-7 is made of, beyond the lengths of robot/body: servos as DC motors, masses,
// contacts, the ball. Decided by walks and kicks of real robots (docs/physical-body.md). SI units.
#pragma once

#include "robot/core/fields/Fields.h"
#include "robot/core/types/Joints.h"

namespace kelpie::sim {

// Joints with a servo in the physical model, in the order of its actuators: all but the tail's.
constexpr std::size_t kServoCount = index(Joint::tailTilt);

// A DC motor behind a proportional controller: torque = stall * duty - stall / noLoad * speed, with
// duty = kp * error / stall, at most 1. The gains are those of the standard OPEN-R gain; others
// scale them.
struct Servo {
  double stall = 1.0;   // N m
  double noLoad = 7.5;  // rad/s
  double kp = 10.0;     // N m/rad

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("stall", &Servo::stall, "N m", 0.01, 10),
                     field("noLoad", &Servo::noLoad, "rad/s", 0.1, 100),
                     field("kp", &Servo::kp, "N m/rad", 0.01, 100));
  }
};

struct ServoParams {
  Servo leg;                        // rotator and knee
  double shoulderGain = 20.0 / 28;  // of the leg's kp: gains 14h and 1Ch
  Servo neckTilt{0.8, 4.5, 2.86};   // gain 0Ah of the 1Ch that is 8 N m/rad (physics.md section 10)
  Servo headPan{0.8, 14.0, 2.29};
  Servo headNod{0.8, 8.0, 2.29};
  Servo mouth{0.15, 10.1, 2.29};
  double armature = 0.0015;  // kg m2, a rotor of 0.5 to 1 g cm2 behind 1:150
  double legPlay = 0.0;      // rad between the two sides of a leg's gears

  template <int = 0>
  static constexpr auto fields() {
    using P = ServoParams;
    return fieldList(field("leg", &P::leg), field("shoulderGain", &P::shoulderGain, "", 0.1, 2),
                     field("neckTilt", &P::neckTilt), field("headPan", &P::headPan),
                     field("headNod", &P::headNod), field("mouth", &P::mouth),
                     field("armature", &P::armature, "kg m2", 1e-4, 0.1),
                     field("legPlay", &P::legPlay, "rad", 0, 0.1));
  }
};

struct MassParams {
  double trunk = 0.80;
  double trunkBehind = 0.06;  // m, of its centre behind the front shoulder axis
  double neck = 0.05;
  double head = 0.18;
  double jaw = 0.02;
  double upperLeg = 0.10;  // with the shoulder
  double lowerLeg = 0.05;

  template <int = 0>
  static constexpr auto fields() {
    using P = MassParams;
    return fieldList(
        field("trunk", &P::trunk, "kg", 0.1, 5), field("trunkBehind", &P::trunkBehind, "m", 0, 0.2),
        field("neck", &P::neck, "kg", 0.001, 1), field("head", &P::head, "kg", 0.01, 2),
        field("jaw", &P::jaw, "kg", 0.001, 1), field("upperLeg", &P::upperLeg, "kg", 0.01, 1),
        field("lowerLeg", &P::lowerLeg, "kg", 0.01, 1));
  }
};

struct ContactParams {
  double carpet = 0.7;   // friction of paws and all else on the carpet
  double plastic = 0.3;  // of robots on robots
  double time = 0.02;    // s, of the contact's spring

  template <int = 0>
  static constexpr auto fields() {
    using P = ContactParams;
    return fieldList(field("carpet", &P::carpet, "", 0.05, 3),
                     field("plastic", &P::plastic, "", 0.01, 3),
                     field("time", &P::time, "s", 0.005, 0.1));
  }
};

// Deceleration on the carpet while rolling at v: drag * v + roll.
struct PhysicalBallParams {
  double mass = 0.04;     // kg, of a hollow sphere
  double friction = 0.3;  // hard plastic on plastic; 0.5 brakes a held ball (physics.md section 10)
  double time = 0.01;     // s, of its contacts; with the ratio 0.25 it bounces at 0.56
  double damping = 0.25;
  double drag = 0.76;  // 1/s
  double roll = 0.06;  // m/s2

  template <int = 0>
  static constexpr auto fields() {
    using P = PhysicalBallParams;
    return fieldList(
        field("mass", &P::mass, "kg", 0.005, 1), field("friction", &P::friction, "", 0.01, 3),
        field("time", &P::time, "s", 0.005, 0.1), field("damping", &P::damping, "", 0.05, 2),
        field("drag", &P::drag, "1/s", 0, 10), field("roll", &P::roll, "m/s2", 0, 5));
  }
};

struct PhysicsParams {
  ServoParams servo;
  MassParams mass;
  ContactParams contact;
  PhysicalBallParams ball;
  double step = 0.002;  // s, the longest; 0.004 is as good where only walks are learnt

  template <int = 0>
  static constexpr auto fields() {
    using P = PhysicsParams;
    return fieldList(field("servo", &P::servo), field("mass", &P::mass),
                     field("contact", &P::contact), field("ball", &P::ball),
                     field("step", &P::step, "s", 0.0005, 0.004));
  }
};

}  // namespace kelpie::sim
