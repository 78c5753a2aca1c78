// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/Tilt.h"

#include <algorithm>
#include <cmath>

#include "gps/Gaussian.h"
#include "gps/Refusal.h"

namespace kelpie::gps {
namespace {

constexpr double kGravity = 981.0;        // cm/s2
constexpr double kTrustedGravity = 40.0;  // cm/s2 that a body at rest may be off
constexpr double kImagesOfTenSeconds = 300.0;

const Angle kKnownSd = Angle::deg(0.02);  // where it is not estimated

void add(const ElevationError& error, Angle heading, const TiltParams& params,
         TiltSightings& sightings) {
  const double excess = -error.value.rad();
  if (!(error.variance > 0.0) || !std::isfinite(error.variance) || !std::isfinite(excess)) return;
  sightings.push_back(
      {-heading.sin(), heading.cos(), excess, error.variance + maths::square(params.swaySd.rad())});
}

// Of a body at rest: the part of gravity along and across it, as far as the stance does not expect
// it.
void addAccelerometer(const GpsIn& in, const TiltParams& params, TiltSightings& sightings) {
  const auto [forward, left, up] = in.input.sensors.acceleration;
  const double size = std::sqrt(forward * forward + left * left + up * up);
  if (!(std::fabs(size - kGravity) < kTrustedGravity)) return;
  const double variance = kImagesOfTenSeconds * maths::square(params.accelerometerSd.rad());
  const CameraTilt& readWith = in.camera.tilt;
  const double noseDown = maths::asin(-forward / size);
  const double leftUp = maths::asin(left / size);
  const double tilt = in.input.stance.bodyTilt.rad() - noseDown - readWith.tilt.rad();
  sightings.push_back({0.0, 1.0, tilt, variance});
  sightings.push_back({-1.0, 0.0, leftUp - readWith.roll.rad(), variance});
}

}  // namespace

CameraTilt startingTilt(const TiltParams& params) {
  const Angle sd = params.use ? params.initialSd : kKnownSd;
  CameraTilt tilt;
  tilt.tiltVariance = tilt.rollVariance = maths::square(sd.rad());
  return tilt;
}

void driftTilt(double elapsed, const TiltParams& params, Modes& modes) {
  if (!params.use) return;
  const double grown = elapsed * maths::square(params.driftSd.rad());
  const double most = maths::square(params.initialSd.rad());
  for (PoseMode& mode : modes) {
    double& tilt = mode.tilt.tiltVariance;
    double& roll = mode.tilt.rollVariance;
    tilt = std::max(tilt, std::min(tilt + grown, most));
    roll = std::max(roll, std::min(roll + grown, most));
  }
}

bool correctTilt(const TiltSighting& z, const CameraTilt& readWith, const TiltParams& params,
                 PoseMode& mode) {
  Vector5 direction = Vector5::Zero();
  direction(3) = z.forward;
  direction(4) = -z.right;
  const Matrix5 covariance = stateCovarianceOf(mode);
  const Vector5 shared = covariance * direction;
  const double variance = direction.dot(shared) + z.variance;
  const double known = z.forward * (mode.tilt.tilt - readWith.tilt).rad() -
                       z.right * (mode.tilt.roll - readWith.roll).rad();
  const double innovation = z.excess - known;
  if (!(innovation * innovation <= maths::square(params.gate) * variance)) return false;
  setState(mode, stateOf(mode) + shared * (innovation / variance),
           covariance - shared * shared.transpose() / variance);
  if (!params.joint) mode.cross = {};
  return true;
}

TiltSightings elevationSightings(const GpsIn& in, const TiltParams& params) {
  TiltSightings sightings;
  for (const LandmarkPercept& landmark : in.percepts.landmarks)
    add(landmark.elevationError, landmark.heading, params, sightings);
  const BallPercept& ball = in.percepts.ball;
  if (ball.present) add(ball.elevationError, ball.heading, params, sightings);
  addAccelerometer(in, params, sightings);
  return sightings;
}

void useTiltSightings(const TiltSightings& sightings, const CameraTilt& readWith,
                      const TiltParams& params, Modes& modes, GpsCounts& counts) {
  for (const TiltSighting& z : sightings) {
    PoseMode best = modes[0];
    if (!correctTilt(z, readWith, params, best)) {
      count(Refusal::tiltUnlikely, counts);
      continue;
    }
    for (PoseMode& mode : modes) correctTilt(z, readWith, params, mode);
  }
}

}  // namespace kelpie::gps
