// SPDX-License-Identifier: Apache-2.0
// A ball is put between a physical robot's chin, chest and forelegs, as a grab leaves it there, and
// is found there or not.
#pragma once

#include "tools/learn/walk/PhysicalWalker.h"

namespace kelpie::learn {

// The head that holds a ball (physics.md section 10), its jaw open; the legs stand as that walk
// does.
Command holdingCommand();

// The robot takes up the stance and lets the ball come: it lies `ahead` of the neck base and so far
// to the right; the head goes down, then the jaw opens. Ends standing, the ball at rest.
void giveBall(Point2<Robot> place, PhysicalWalker& walker);
constexpr double kHeldAhead = 9.5;  // cm, a ball that the head then draws in

// By its true place.
bool holdsBall(PhysicalWalker& walker);

}  // namespace kelpie::learn
