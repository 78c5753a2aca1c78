// SPDX-License-Identifier: Apache-2.0
// What the behaviours ask of the body for the next frame. Validated and clamped by behaviour/.
#pragma once

#include <cstdint>

#include "robot/core/Angle.h"
#include "robot/core/Fields.h"

namespace kelpie {

// Wished speed of the robot frame.
struct WalkRequest {
  double forward = 0.0;  // cm/s
  double left = 0.0;     // cm/s
  double turn = 0.0;     // rad/s, left positive

  static constexpr auto fields() {
    return fieldList(field("forward", &WalkRequest::forward, "cm/s", -30, 42),
                     field("left", &WalkRequest::left, "cm/s", -20, 20),
                     field("turn", &WalkRequest::turn, "rad/s", -3.8, 3.8));
  }
};

struct HeadRequest {
  Angle neckTilt;
  Angle headPan;
  Angle headNod;
  double speed = 0.0;  // rad/s at most for each joint; 0 = as fast as the joints go

  static constexpr auto fields() {
    return fieldList(field("neckTilt", &HeadRequest::neckTilt, "rad", -75, 0),
                     field("headPan", &HeadRequest::headPan, "rad", -88, 88),
                     field("headNod", &HeadRequest::headNod, "rad", -15, 45),
                     field("speed", &HeadRequest::speed, "rad/s", 0, 10));
  }
};

// Special motions: sequences of poses that replace the walk while they run.
enum class MotionKind : std::uint8_t { none, stand, kickForward };
constexpr std::uint8_t kMotionKindCount = 3;

// Why the behaviour host answered in place of the script.
enum class Fallback : std::uint8_t { none, notLoaded, scriptError, badCommand, timeLimit };

// What the localiser does with pink patches on the outer wall (thesis 2004 section 4.1): nothing,
// remember where they are, or find out by them where the robot is.
enum class PinkUse : std::uint8_t { off, map, localise };
constexpr std::uint8_t kPinkUseCount = 3;

struct Command {
  WalkRequest walk;
  HeadRequest head;
  bool mouthOpen = false;
  MotionKind motion = MotionKind::none;  // started when it differs from none and nothing runs
  std::uint32_t leds = 0;
  bool localise = false;  // while standing: find the pose by the field lines alone
  PinkUse pinks = PinkUse::off;
  Fallback fallback = Fallback::none;

  static constexpr auto fields() {
    return fieldList(field("walk", &Command::walk), field("head", &Command::head),
                     field("mouthOpen", &Command::mouthOpen),
                     field("motion", &Command::motion, "", 0, kMotionKindCount - 1),
                     field("leds", &Command::leds), field("localise", &Command::localise),
                     field("pinks", &Command::pinks, "", 0, kPinkUseCount - 1),
                     field("fallback", &Command::fallback, "", 0, 4));
  }
};

}  // namespace kelpie
