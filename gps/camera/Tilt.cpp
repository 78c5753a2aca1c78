// SPDX-License-Identifier: Apache-2.0
#include "gps/camera/Tilt.h"

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
  sightings.push_back({-heading.sin(), heading.cos(), excess,
                       error.variance + maths::square(params.oscillationSd.rad())});
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
  const Angle known = in.input.stance.bodyTilt + in.camera.bodyTiltOffset;
  const double tilt = known.rad() - noseDown - readWith.tilt.rad();
  const double roll = leftUp - in.camera.bodyRollOffset.rad() - readWith.roll.rad();
  sightings.push_back({0.0, 1.0, tilt, variance});
  sightings.push_back({-1.0, 0.0, roll, variance});
}

Vector2 directionOf(const TiltSighting& z) { return {z.forward, -z.right}; }

// What several sightings say of tilt and roll beyond those that the image was read with.
struct TiltInformation {
  Matrix2 matrix = Matrix2::Zero();
  Vector2 vector = Vector2::Zero();

  void add(const TiltSighting& z) {
    const Vector2 direction = directionOf(z);
    matrix += direction * direction.transpose() / z.variance;
    vector += direction * (z.excess / z.variance);
  }
};

bool passesGate(const TiltSighting& z, const Vector2& readWith, double gate,
                const CameraTilt& tilt) {
  const Vector2 direction = directionOf(z);
  const double variance = direction.dot(tiltCovarianceOf(tilt) * direction) + z.variance;
  const double innovation = z.excess - direction.dot(tiltMeanOf(tilt) - readWith);
  return innovation * innovation <= maths::square(gate) * variance;
}

// As `corrected` by an observation of the pose, with tilt and pose in each other's place.
void correct(const TiltInformation& seen, const Vector2& readWith, bool joint, PoseMode& mode) {
  const Matrix2 tilt = tiltCovarianceOf(mode.tilt);
  const Matrix2 sum = Matrix2::Identity() + tilt * seen.matrix;
  const Matrix2 shrink = sum.inverse();
  const Matrix2 after = shrink * tilt;
  const Vector2 pull = seen.vector - seen.matrix * (tiltMeanOf(mode.tilt) - readWith);
  const Vector2 shift = after * pull;
  setTilt(mode.tilt, tiltMeanOf(mode.tilt) + shift, after);
  if (!joint) return;
  const Matrix32 cross = crossOf(mode);
  const Matrix32 left = cross * shrink.transpose();
  mode.pose = poseOf(meanOf(mode) + cross * (pull - seen.matrix * shift));
  setCovariance(mode, covarianceOf(mode) - left * seen.matrix * cross.transpose());
  setCross(mode, left);
}

}  // namespace

CameraTilt startingTilt(const TiltParams& params) {
  const Angle sd = params.use ? params.initialSd : kKnownSd;
  CameraTilt tilt;
  tilt.tiltVariance = tilt.rollVariance = maths::square(sd.rad());
  return tilt;
}

void driftTilt(double elapsed, double shaking, const TiltParams& params, Modes& modes) {
  if (!params.use) return;
  const double sway = params.swaySd.rad() * shaking;
  const double grown = elapsed * (maths::square(params.driftSd.rad()) + maths::square(sway));
  const double max = maths::square(params.initialSd.rad());
  for (PoseMode& mode : modes) {
    double& tilt = mode.tilt.tiltVariance;
    double& roll = mode.tilt.rollVariance;
    tilt = std::max(tilt, std::min(tilt + grown, max));
    roll = std::max(roll, std::min(roll + grown, max));
  }
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
  const Vector2 read = tiltMeanOf(readWith);
  TiltInformation sum;
  for (const TiltSighting& z : sightings) {
    if (passesGate(z, read, params.gate, modes[0].tilt)) {
      sum.add(z);
    } else {
      count(Refusal::tiltUnlikely, counts);
    }
  }
  for (PoseMode& mode : modes) correct(sum, read, params.joint, mode);
}

}  // namespace kelpie::gps
