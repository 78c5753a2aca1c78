// SPDX-License-Identifier: Apache-2.0
// Motion files (actuator/README.md tells their keys), read and written. The standard ones are
// compiled in by actuator/data/compile.py; this reader takes the same files while the program runs.
#pragma once

#include <string>

#include "actuator/motion/MotionData.h"
#include "robot/core/Expected.h"

namespace kelpie::learn {

// A motion as its file has it; of a file that says `mirror = "NAME"` the motion of NAME.toml beside
// it, left and right exchanged. Errors name file and line, or the number that is out of range.
Expected<actuator::MotionData> readMotion(const std::string& path);

// The text of such a file; the lines of `about` say what the motion does. `kind`: which it is, so
// that it says what its file has to say to be listed; none: a motion of no file.
std::string motionText(const actuator::MotionData& motion, const std::string& about,
                       MotionKind kind = MotionKind::none);

// The kind of that name ("head_swipe_left").
Expected<MotionKind> motionNamed(const std::string& name);

}  // namespace kelpie::learn
