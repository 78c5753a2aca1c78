// SPDX-License-Identifier: Apache-2.0
// The colours of the drawings of a match: one colour, one meaning.
#pragma once

#include "robot/core/types/FrameInput.h"
#include "robot/core/types/Percepts.h"
#include "tools/picture/Canvas.h"

namespace kelpie::match::inks {

using picture::Ink;

constexpr Ink kGround{0.075, 0.086, 0.102};
constexpr Ink kPanel{0.118, 0.133, 0.157};
constexpr Ink kText{0.93, 0.94, 0.95};
constexpr Ink kQuiet{0.62, 0.66, 0.70};
constexpr Ink kCarpet{0.145, 0.345, 0.200};
constexpr Ink kPaint{0.52, 0.66, 0.56};  // lines of the field, quieter than any path
constexpr Ink kRobot{1.0, 1.0, 1.0};     // where the log's robot really is
constexpr Ink kBelief{1.0, 0.55, 0.85};  // what it believes
constexpr Ink kBall{1.0, 0.52, 0.08};    // the ball, real and seen
constexpr Ink kRed{0.93, 0.30, 0.27};
constexpr Ink kBlue{0.33, 0.56, 1.0};
constexpr Ink kYellowGoal{0.98, 0.82, 0.16};
constexpr Ink kBlueGoal{0.20, 0.42, 0.90};
constexpr Ink kPink{0.95, 0.45, 0.65};  // of beacons
constexpr Ink kLinePoint{1.0, 1.0, 0.35};
constexpr Ink kBorderPoint{0.4, 1.0, 1.0};
constexpr Ink kCarpetPoint{0.55, 1.0, 0.55};
constexpr Ink kObstacle{0.85, 0.45, 1.0};
constexpr Ink kCarpetEdge{1.0, 0.40, 0.35};

constexpr Ink of(TeamColour team) { return team == TeamColour::red ? kRed : kBlue; }
constexpr Ink of(LinePointKind kind) {
  return kind == LinePointKind::line     ? kLinePoint
         : kind == LinePointKind::border ? kBorderPoint
                                         : kCarpetPoint;
}
constexpr Ink of(LandmarkKind kind) {
  return kind == LandmarkKind::goalBlue     ? kBlue
         : kind == LandmarkKind::goalYellow ? kYellowGoal
                                            : kPink;
}
// `share` of the second in the first.
constexpr Ink mixed(const Ink& a, const Ink& b, double share) {
  return {a.red + share * (b.red - a.red), a.green + share * (b.green - a.green),
          a.blue + share * (b.blue - a.blue)};
}

}  // namespace kelpie::match::inks
