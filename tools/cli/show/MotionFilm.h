// SPDX-License-Identifier: Apache-2.0
// Film and picture of one motion on the physical body (tools/learn/motion/MotionPlay.h). Both are
// written whole or not at all.
#pragma once

#include <string>

#include "actuator/motion/MotionData.h"
#include "tools/learn/motion/MotionPlay.h"

namespace kelpie::cli {

// One picture a tick, 30 a second: four times slower than it was.
Status filmMotion(const learn::MotionCourse& course, const std::string& name,
                  const std::string& out);
constexpr int kSlower = 4;

// The moments at which a key frame ends, before the first and some time after the last, in one PNG.
Status drawMotion(const learn::MotionCourse& course, const actuator::MotionData& motion,
                  const std::string& name, const std::string& out);

}  // namespace kelpie::cli
