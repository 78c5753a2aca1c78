// SPDX-License-Identifier: Apache-2.0
// One robot of the stage, to be looked at: white shell, dark joints, the team's uniform on back,
// shoulders, hips and head. Where joints are comes from robot/body; shapes are chosen to look like
// an ERS-7.
#pragma once

#include <string>

#include "robot/core/types/FrameInput.h"

namespace kelpie::broadcast {

std::string dogXml(TeamColour team, int player);

}  // namespace kelpie::broadcast
