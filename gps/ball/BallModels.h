// SPDX-License-Identifier: Apache-2.0
// The ball under two models at once, lying and rolling, each a Kalman filter, weighed by how well
// they predict the sightings (an interacting multiple model filter: Blom and Bar-Shalom 1988). One
// filter alone must choose its noise between a lying ball that seems to move and a rolling one that
// lags. Fails on a ball pushed along slowly: it lies, again and again.
#pragma once

#include "gps/ball/BallFilterParams.h"
#include "gps/ball/BallGaussian.h"
#include "gps/pose/Predict.h"

namespace kelpie::gps {

// A sighting in the robot frame, cm and cm2.
struct BallSighting {
  Vector2 position;
  Matrix2 covariance;
};

// A ball just found, which lies with probability `stillWeight` or rolls at a speed around 0.
void beginModels(const BallSighting& z, double speedSd, double stillWeight, BallTrack& ball);

// Own motion, change of model, rolling on.
void predictModels(const Odometry& odometry, const StepNoise& noise, double elapsed,
                   const BallFilterParams& params, BallTrack& ball);

// A kick or a bounce within the last `elapsed` seconds: the velocity is unknown.
void jumpModels(double elapsed, const BallFilterParams& params, BallTrack& ball);

// False when the sighting lies outside the gate of both models (one of less than `minWeight` does
// not count); nothing is changed then.
bool correctModels(const BallSighting& z, double gate, double minWeight, BallTrack& ball);

// Adds to the variance of the position, cm2.
void widenModels(double variance, BallTrack& ball);

// Puts the ball there, lying.
void placeModels(const BallSighting& z, BallTrack& ball);

// Makes `both` of the two.
void combineModels(BallTrack& ball);

}  // namespace kelpie::gps
