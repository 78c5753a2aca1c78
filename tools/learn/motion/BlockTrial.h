// SPDX-License-Identifier: Apache-2.0
// What a block stops: how wide the robot is at the ball's height while it lies there, and whether
// balls that roll at it come by. One physical model at a time.
#pragma once

#include "tools/learn/motion/MotionPlay.h"

namespace kelpie::learn {

constexpr double kBlockSeconds = 0.6;  // after it was asked for, until the ball is there
// The ball comes to this line, that of the chest (docs/physical-body.md).
constexpr double kBlockAhead = 5.0;  // cm before the neck base

bool isBlock(MotionKind kind);

struct BlockCover {
  double left = 0.0;     // cm from the middle of the body as it stood
  double right = 0.0;    // cm
  double seconds = 0.0;  // from asking until nine tenths of it are covered
  double lean = 0.0;     // deg, the greatest
  bool fell = false;
  bool stands = false;  // in the end
  Point2<Robot> way;    // cm, where it is then
  Angle turn;
};
// No ball comes. The stage stays as it is.
BlockCover coverOf(const MotionStage& stage);

struct BlockedBall {
  bool stopped = false;     // kBallPassed
  bool thrownBack = false;  // and rolls away from the goal
  bool fell = false;
  bool stands = false;
};
// `lateral`: cm to the right, where the ball comes to the line. The stage stays as it is.
BlockedBall tryBlock(const MotionStage& stage, double lateral, double speed, Angle from);

// The mean over robots that stand, of a motion in place of theirs: 1 for 25 cm covered to the side
// that it is for, of a block to both sides the lesser, all the while from 0.35 s on until 0.3 s
// after the ball would be there; less where it leans by more than 25 deg, or falls.
double blockGain(const actuator::MotionData& motion, const std::vector<MotionStage>& stages);

}  // namespace kelpie::learn
