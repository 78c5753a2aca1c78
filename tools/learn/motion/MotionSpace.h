// SPDX-License-Identifier: Apache-2.0
// The numbers of a motion that are searched: of each key frame its ticks, leg angles and head. A
// motion whose legs are alike left and right has one number for both.
#pragma once

#include "actuator/motion/MotionData.h"
#include "tools/learn/Search.h"

namespace kelpie::learn {

// `reach`: how far from the start each angle may go.
SearchSpace motionSpace(const actuator::MotionData& start, Angle reach);
actuator::MotionData motionOf(const std::vector<double>& point, const actuator::MotionData& start);

// Left and right exchanged, the head turned to the other side.
actuator::MotionData mirrored(const actuator::MotionData& motion);

}  // namespace kelpie::learn
