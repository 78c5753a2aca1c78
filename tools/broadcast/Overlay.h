// SPDX-License-Identifier: Apache-2.0
// What is drawn over and beside the stage: score and clock, the robots' numbers, who has the ball,
// a small map, what was called, and why the watched robot does what it does.
#pragma once

#include <string>
#include <vector>

#include "robot/body/FieldDescription.h"
#include "tools/broadcast/Captions.h"
#include "tools/broadcast/Stage.h"
#include "tools/match/Draw.h"
#include "tools/match/MatchWords.h"
#include "tools/picture/Canvas.h"

namespace kelpie::broadcast {

// Teams, score and clock, from the upper left corner on.
void drawScore(picture::Canvas& canvas, picture::Spot corner, const match::MatchFacts& facts);
// A robot's number over its back; a ring round that of the watched one.
void drawNumber(picture::Canvas& canvas, picture::Spot where, const Actor& actor, bool watched);
// In the middle of the stage's lower edge.
void drawBanner(picture::Canvas& canvas, const picture::Frame& stage, const std::string& words);
// The field lying down, the yellow goal at the left as the cameras see it.
void drawMap(picture::Canvas& canvas, const picture::Frame& frame,
             const body::FieldDescription& field, const Tableau& tableau, const Actor* watched);
void drawCalls(picture::Canvas& canvas, const picture::Frame& frame, const std::string& ball,
               const std::vector<Call>& calls);
// Who decided what and why, from player to skill.
void drawReasons(picture::Canvas& canvas, const picture::Frame& frame, const match::Moment& moment);

}  // namespace kelpie::broadcast
