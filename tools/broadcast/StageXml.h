// SPDX-License-Identifier: Apache-2.0
// Field and robots as a MuJoCo model that is looked at only: light, carpet, paint, goals, beacons,
// the ball and robots in uniforms, joints and lengths by robot/body. Nothing in it touches
// anything; places are set, never simulated. Metres, axes as the red team's field.
#pragma once

#include <set>
#include <string>
#include <utility>

#include "robot/body/FieldDescription.h"
#include "robot/core/types/FrameInput.h"

namespace kelpie::broadcast {

using Player = std::pair<TeamColour, int>;
constexpr std::size_t kRobotsOfTeam = 4;

// "red1": the body of a robot; its joints are "red1_free" and "red1_<joint index>".
std::string slotName(TeamColour team, int player);
constexpr std::size_t kHinges = 16;  // the head's four and the legs' twelve

// `width` and `height` of the pictures that are made of it, in pixels. Every robot costs time in
// every picture, seen or not.
std::string stageXml(const body::FieldDescription& field, const std::set<Player>& players,
                     int width, int height);

}  // namespace kelpie::broadcast
