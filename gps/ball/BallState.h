// SPDX-License-Identifier: Apache-2.0
// What the ball filter remembers between frames. Plain data.
#pragma once

#include <array>
#include <cstdint>

namespace kelpie::gps {

// Position and velocity in the robot frame: x right, y forward, vx, vy; covariance row by row.
struct BallHypothesis {
  double weight = 0.0;
  std::array<double, 4> mean{};
  std::array<double, 16> covariance{};
};

struct BallTrack {
  bool present = false;
  BallHypothesis still;    // it lies: no velocity and no variance of it
  BallHypothesis rolling;  // it rolls freely, slowed by the carpet
  BallHypothesis both;     // one Gaussian for the two: what is published
  double secondsSinceSeen = 0.0;
  double weightedUnseenSeconds = 0.0;  // seconds in which it should be seen count more
  std::uint32_t missed = 0;            // frames in a row in which it should have been seen
  bool candidatePresent = false;       // a sighting that waits for a second one like it
  std::array<double, 2> candidate{};
  double candidateAge = 0.0;      // s
  double secondsSinceKick = 1e9;  // of our own at this ball
};

struct BallState {
  BallTrack track;
  // What the track would be if the last sighting, which did not fit it, was of a kick or a bounce:
  // a second hypothesis that the next sightings decide on.
  BallTrack jumped;
  std::uint32_t goals = 0;  // of both teams, to notice a new one
};

}  // namespace kelpie::gps
