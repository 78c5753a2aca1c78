// SPDX-License-Identifier: Apache-2.0
// Field and robots as a MuJoCo model that is looked at only: light, carpet, paint, goals, beacons,
// the ball and robots in uniforms, joints and lengths by robot/body. Nothing in it touches
// anything; places are set, never simulated. Metres, axes as the red team's field.
#pragma once

#include <set>
#include <string>

#include "robot/body/FieldDescription.h"
#include "tools/broadcast/Player.h"

namespace kelpie::broadcast {

// `width` and `height` of the pictures that are made of it, in pixels. Every robot costs time in
// every picture, seen or not.
std::string stageXml(const body::FieldDescription& field, const std::set<Player>& players,
                     int width, int height);

}  // namespace kelpie::broadcast
