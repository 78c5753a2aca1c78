// SPDX-License-Identifier: Apache-2.0
// Plays the key frames of a special motion, tick by tick. Legs that walk are left to the caller.
#pragma once

#include "actuator/motion/MotionData.h"

namespace kelpie::actuator {

struct MotionState {
  MotionKind kind = MotionKind::none;
  std::uint32_t tick = 0;   // since it began
  std::uint32_t frame = 0;  // the key frame that is played
  std::uint32_t frameTick = 0;
  JointAngles from;       // the targets as the key frame began
  bool answered = false;  // the request that started it still stands: do not start again
};

inline bool running(const MotionState& state) { return state.kind != MotionKind::none; }

void begin(MotionKind kind, const JointAngles& now, MotionState& state);

// The key frame that is played, and the targets of this tick: head, mouth and legs of `asked` (what
// the Command wants, legs in the stance or walk of the key frame) replaced by what it moves.
const KeyFrame& keyFrame(const Motions& motions, const MotionState& state);
JointAngles played(const Motions& motions, const JointAngles& asked, const MotionState& state);

// Whether it goes twice as fast, because of the motion that the Command asks for.
bool hurried(const Motions& motions, MotionKind asked, const MotionState& state);

// Share of the legs' standard gain that it wants: 1 between motions.
double legGain(const Motions& motions, const MotionState& state);

// One tick on; false when it has ended. `now`: the targets that were commanded.
bool advance(const Motions& motions, const JointAngles& now, MotionState& state);

}  // namespace kelpie::actuator
