// SPDX-License-Identifier: Apache-2.0
// What the behaviours ask of the body for the next frame. Validated and clamped by behaviour/.
#pragma once

#include <cstdint>

#include "robot/core/Angle.h"
#include "robot/core/Enumerations.h"
#include "robot/core/FixedVector.h"
#include "robot/core/Text.h"
#include "robot/core/fields/Fields.h"
#include "robot/core/types/Geometry.h"
#include "robot/core/types/TeamNote.h"

namespace kelpie {

// Which set of the actuator's walk parameters is used. `weak` is for weakly held legs: the actuator
// takes it by itself in place of any other while the battery is spared.
enum class WalkKind : std::uint8_t { normal, fast, turning, dribble, back, low, weak };
constexpr std::uint8_t kWalkKindCount = 7;

// Wished speed of the robot frame over the ground, as it shall really be. What is too fast is
// scaled down, its direction kept.
struct WalkRequest {
  double forward = 0.0;  // cm/s
  double left = 0.0;     // cm/s
  double turn = 0.0;     // rad/s, left positive
  double pivot = 0.0;    // cm ahead of the neck base: what the turn is about, a ball for example
  WalkKind kind = WalkKind::normal;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("forward", &WalkRequest::forward, "cm/s", -45, 60),
                     field("left", &WalkRequest::left, "cm/s", -35, 35),
                     field("turn", &WalkRequest::turn, "rad/s", -4.5, 4.5),
                     field("pivot", &WalkRequest::pivot, "cm", -30, 60),
                     field("kind", &WalkRequest::kind, "", 0, kWalkKindCount - 1));
  }
};

// What a HeadRequest names: three joints, the direction of the camera's axis, or a point.
enum class HeadAim : std::uint8_t { joints, direction, point };
constexpr std::uint8_t kHeadAimCount = 3;

struct HeadRequest {
  Angle neckTilt;
  Angle headPan;
  Angle headNod;
  double speed = 0.0;  // rad/s at most for each joint; 0 = as fast as the joints go
  HeadAim aim = HeadAim::joints;
  Angle direction;       // to the left of the body's axis
  Angle elevation;       // above the horizon
  Point3<Robot> target;  // cm

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("neckTilt", &HeadRequest::neckTilt, "rad", -75, 0),
                     field("headPan", &HeadRequest::headPan, "rad", -88, 88),
                     field("headNod", &HeadRequest::headNod, "rad", -15, 45),
                     field("speed", &HeadRequest::speed, "rad/s", 0, 10),
                     field("aim", &HeadRequest::aim, "", 0, kHeadAimCount - 1),
                     field("direction", &HeadRequest::direction, "rad", -180, 180),
                     field("elevation", &HeadRequest::elevation, "rad", -90, 90),
                     field("target", &HeadRequest::target, "cm", -1000, 1000));
  }
};

struct TailRequest {
  Angle tilt = Angle::deg(30.0);
  Angle pan;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("tilt", &TailRequest::tilt, "rad", 5, 60),
                     field("pan", &TailRequest::pan, "rad", -45, 45));
  }
};

// Never up for long (openr.md 5.6).
struct EarRequest {
  bool leftUp = false;
  bool rightUp = false;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("leftUp", &EarRequest::leftUp), field("rightUp", &EarRequest::rightUp));
  }
};

// Why the behaviour host answered in place of the script.
enum class Fallback : std::uint8_t { none, notLoaded, scriptError, badCommand, timeLimit };

// What the localiser does with pink patches on the outer wall (thesis 2004 section 4.1): nothing,
// remember where they are, or find out by them where the robot is.
enum class PinkUse : std::uint8_t { off, map, localise };
constexpr std::uint8_t kPinkUseCount = 3;

// Who decided, from who plays down to how it is done (thesis 2006 figures 4.1 and 5.1).
enum class TraceLayer : std::uint8_t { player, role, decision, skill };
constexpr std::uint8_t kTraceLayerCount = 4;

// One decision on the way to a Command. Each {} in `reason` stands for the next of `numbers`.
struct TraceStep {
  TraceLayer layer = TraceLayer::player;
  Text<20> module;  // whose decision it is: "grab_dribble"
  Text<24> branch;  // what was chosen: "aim"
  Text<80> reason;  // why: "the gap is {} deg to the left"
  FixedVector<double, 3> numbers;

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("layer", &TraceStep::layer, "", 0, kTraceLayerCount - 1),
                     field("module", &TraceStep::module), field("branch", &TraceStep::branch),
                     field("reason", &TraceStep::reason),
                     field("numbers", &TraceStep::numbers, "", -1e6, 1e6));
  }
};
// From the player down.
using Trace = FixedVector<TraceStep, 9>;

struct Command {
  WalkRequest walk;
  HeadRequest head;
  bool mouthOpen = false;
  TailRequest tail;
  EarRequest ears;
  MotionKind motion = MotionKind::none;  // started when it differs from none and nothing runs
  std::uint32_t leds = 0;
  bool localise = false;  // while standing: find the pose by the field lines alone
  PinkUse pinks = PinkUse::off;
  TeamNote team;  // for the next message to the team
  Fallback fallback = Fallback::none;
  Trace trace;  // why all this; empty where it is repeated (FrameInput, MotionInput)

  template <int = 0>
  static constexpr auto fields() {
    return fieldList(field("walk", &Command::walk), field("head", &Command::head),
                     field("mouthOpen", &Command::mouthOpen), field("tail", &Command::tail),
                     field("ears", &Command::ears),
                     field("motion", &Command::motion, "", 0, kMotionKindCount - 1),
                     field("leds", &Command::leds), field("localise", &Command::localise),
                     field("pinks", &Command::pinks, "", 0, kPinkUseCount - 1),
                     field("team", &Command::team), field("fallback", &Command::fallback, "", 0, 4),
                     field("trace", &Command::trace));
  }
};

}  // namespace kelpie
