// SPDX-License-Identifier: Apache-2.0
// A robot seen from its side, painted as flat walls of an ERS-7's sizes: white trunk and head, grey
// legs, a patch on the flank and one on the head. Its own numbers, not the simulator's.
#pragma once

#include "tests/vision/Painting.h"

namespace kelpie::vision {

constexpr Paint kGreyPaint{95, 127, 128};
constexpr Paint kBlackPaint{20, 126, 128};
constexpr Paint kDarkBluePaint{28, 126, 147};

struct PatchPlace {
  double from = 0.0;  // cm to the right of the robot's middle
  double to = 0.0;
  double low = 0.0;
  double high = 0.0;
};
constexpr PatchPlace kFlankPatch{-5.0, 2.0, 9.0, 14.0};
constexpr PatchPlace kHeadPatch{7.0, 11.0, 17.0, 21.0};

inline void addWall(Painting& painting, double x, double y, const PatchPlace& place, Paint paint) {
  painting.walls.push_back({{x + place.from, y}, {x + place.to, y}, place.low, place.high, paint});
}

// At x, y in the robot frame, square to the y axis, its head to the right.
inline void addRobot(Painting& painting, double x, double y, Paint team) {
  addWall(painting, x, y, {-11.0, 8.0, 6.5, 15.0}, kWhitePaint);
  addWall(painting, x, y, {5.0, 14.0, 14.0, 23.0}, kWhitePaint);
  addWall(painting, x, y, {-11.0, -6.5, 0.0, 7.0}, kGreyPaint);
  addWall(painting, x, y, {2.5, 7.0, 0.0, 7.0}, kGreyPaint);
  addWall(painting, x, y - 0.05, kFlankPatch, team);
  addWall(painting, x, y - 0.05, kHeadPatch, team);
}

}  // namespace kelpie::vision
