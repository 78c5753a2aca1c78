// SPDX-License-Identifier: Apache-2.0
// Special motions as data: key frames for head and legs. One for each MotionKind, from
// actuator/data/motions/*.toml; the format is described there (README.md).
#pragma once

#include <array>
#include <cstdint>

#include "robot/core/FixedVector.h"
#include "robot/core/types/Command.h"
#include "robot/core/types/Joints.h"

namespace kelpie::actuator {

constexpr std::size_t kLegJoints = 3 * kLegCount;

// What the legs do in a key frame: go to its angles, stay where they are, take up the stance of a
// walk, or walk on.
enum class KeyLegs : std::uint8_t { angles, stay, stance, walk };
constexpr std::uint8_t kKeyLegsCount = 4;

struct KeyFrame {
  std::uint32_t ticks = 1;      // of 8 ms, how long it lasts
  bool interpolate = false;     // in a straight line in joint space; else commanded at once, as the
                                // player of 2005 did (facts-2005 section 6.5)
  bool movesHead = false;       // else the head obeys the Command
  std::array<Angle, 3> head{};  // neck tilt, pan, nod
  bool asksPan = false;         // but the pan obeys the Command all the same
  bool movesMouth = false;      // else so
  Angle mouth;
  KeyLegs legs = KeyLegs::stay;
  double gain = 1.0;  // share of the leg joints' standard proportional gain while it is played
  std::array<Angle, kLegJoints> angles{};  // in the order of Joint
  WalkRequest walk;                        // of `walk`; its kind of `stance`

  template <int = 0>
  static constexpr auto fields() {
    using P = KeyFrame;
    return fieldList(field("ticks", &P::ticks, "", 1, 500), field("interpolate", &P::interpolate),
                     field("movesHead", &P::movesHead), field("head", &P::head, "rad", -88, 88),
                     field("asksPan", &P::asksPan), field("movesMouth", &P::movesMouth),
                     field("mouth", &P::mouth, "rad", -55, -3),
                     field("legs", &P::legs, "", 0, kKeyLegsCount - 1),
                     field("gain", &P::gain, "", 0.2, 1),
                     field("angles", &P::angles, "rad", -130, 130), field("walk", &P::walk));
  }
};

// What a kick does with the ball, as its calibration measured it. Places from the neck base.
struct KickEffect {
  double ahead = 0.0;     // cm, where the ball lies as it begins
  double left = 0.0;      // cm
  double distance = 0.0;  // cm, how far it goes on the mean, until it lies still; 0: is no kick
  double distanceSd = 0.0;
  Angle direction;  // left of straight ahead
  Angle directionSd;

  template <int = 0>
  static constexpr auto fields() {
    using P = KickEffect;
    return fieldList(field("ahead", &P::ahead, "cm", -30, 60),
                     field("left", &P::left, "cm", -30, 30),
                     field("distance", &P::distance, "cm", 0, 1000),
                     field("distanceSd", &P::distanceSd, "cm", 0, 1000),
                     field("direction", &P::direction, "rad", -180, 180),
                     field("directionSd", &P::directionSd, "rad", 0, 180));
  }
};

// How far the robot frame goes in a motion, until it stands again, as its calibration measured it;
// odometry spreads it evenly over the key frames.
struct MotionWay {
  double forward = 0.0;  // cm
  double left = 0.0;     // cm
  Angle turn;
  double forwardSd = 0.0;
  double leftSd = 0.0;
  Angle turnSd;

  template <int = 0>
  static constexpr auto fields() {
    using P = MotionWay;
    return fieldList(
        field("forward", &P::forward, "cm", -100, 100), field("left", &P::left, "cm", -100, 100),
        field("turn", &P::turn, "rad", -180, 180), field("forwardSd", &P::forwardSd, "cm", 0, 100),
        field("leftSd", &P::leftSd, "cm", 0, 100), field("turnSd", &P::turnSd, "rad", 0, 180));
  }
};

struct MotionData {
  FixedVector<KeyFrame, 12> frames;
  Angle slew = Angle::deg(20.0);   // a tick at most, head and legs
  bool atOnce = false;             // starts in the middle of a step too
  std::uint32_t returnTicks = 30;  // from its last pose back to the walk
  // While the Command asks for this one it goes twice as fast, from where it is. Only for motions
  // whose legs walk: nothing is known of the way of others.
  MotionKind hurriedBy = MotionKind::none;
  MotionWay way;
  KickEffect kick;

  template <int = 0>
  static constexpr auto fields() {
    using P = MotionData;
    return fieldList(field("frames", &P::frames), field("slew", &P::slew, "rad", 0.5, 40),
                     field("atOnce", &P::atOnce), field("returnTicks", &P::returnTicks, "", 0, 500),
                     field("hurriedBy", &P::hurriedBy, "", 0, kMotionKindCount - 1),
                     field("way", &P::way), field("kick", &P::kick));
  }
};

// In the order of MotionKind; that of `none` is empty.
struct Motions {
  std::array<MotionData, kMotionKindCount> of{};

  const MotionData& operator[](MotionKind kind) const { return of[placeOf(kind)]; }
  MotionData& operator[](MotionKind kind) { return of[placeOf(kind)]; }
  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("of", &Motions::of));
  }

 private:
  static std::size_t placeOf(MotionKind kind) {
    const auto i = static_cast<std::size_t>(kind);
    return i < kMotionKindCount ? i : 0;
  }
};

std::uint32_t ticksOf(const MotionData& motion);

// The names of the files in actuator/data/motions, in the order of MotionKind.
extern const std::array<const char*, kMotionKindCount> kMotionNames;

// Those of actuator/data/motions.
const Motions& standardMotions();

}  // namespace kelpie::actuator
