// SPDX-License-Identifier: Apache-2.0
#include "gps/pose/Landmarks.h"

#include <algorithm>
#include <cmath>

#include "gps/Refusal.h"

namespace kelpie::gps {
namespace {

bool isGoal(LandmarkKind kind) {
  return kind == LandmarkKind::goalBlue || kind == LandmarkKind::goalYellow;
}

bool usable(const LandmarkPercept& p) {
  return std::isfinite(p.distance) && p.distance > 0.0 &&
         std::fabs(p.heading.rad()) <= maths::kPi && std::isfinite(p.distanceVariance) &&
         p.distanceVariance > 0.0 && std::isfinite(p.headingVariance) && p.headingVariance > 0.0;
}

std::optional<Refusal> refusal(const LandmarkPercept& percept, const LandmarkMap& map,
                               const LandmarkGates& gates) {
  if (!usable(percept)) return Refusal::landmarkNotFinite;
  const body::Landmark* landmark = body::findLandmark(map, percept.kind);
  if (landmark == nullptr) return Refusal::landmarkUnknown;
  const double maxSd = gates.maxHeadingSd.rad();
  if (percept.headingVariance > maxSd * maxSd) return Refusal::headingUncertain;
  if (!isGoal(percept.kind)) return std::nullopt;
  if (percept.distance < gates.goalMin) return Refusal::goalTooClose;
  return std::nullopt;
}

}  // namespace

bool landmarksCount(const FrameInput& input) {
  return input.lastCommand.pinks != PinkUse::localise;
}

Measurement headingOnly(const Measurement& measurement) {
  Measurement m = measurement;
  m.useDistance = false;
  m.useHeading = true;
  m.headingVariance = m.grazingHeadingVariance;
  return m;
}

std::optional<Measurement> measurement(const LandmarkPercept& percept, const LandmarkMap& map,
                                       const body::FieldDescription& field,
                                       const LandmarkGates& gates, GpsCounts& counts) {
  if (const auto reason = refusal(percept, map, gates)) {
    count(*reason, counts);
    return std::nullopt;
  }
  const bool goal = isGoal(percept.kind);
  const double farthest = goal ? gates.goalMaxDistance : gates.beaconMaxDistance;
  Measurement m;
  m.kind = percept.kind;
  m.landmark = body::findLandmark(map, percept.kind)->position;
  m.minGoalLineDistance = goal ? gates.goalLineShare * field.length : 0.0;
  m.distance = percept.distance;
  m.heading = percept.heading;
  m.distanceVariance = std::max(gates.distanceVarianceFactor * percept.distanceVariance,
                                maths::square(gates.minDistanceSd));
  m.headingVariance = std::max(gates.headingVarianceFactor * percept.headingVariance,
                               maths::square(gates.minHeadingSd.rad()));
  m.grazingHeadingVariance = m.headingVariance + maths::square(gates.maxHeadingSd.rad());
  m.useDistance =
      percept.distance <= farthest && percept.distanceVariance <= gates.maxDistanceVariance;
  // The variance of a goal's heading knows what of the goal is cut or hidden.
  m.useHeading = true;
  return m;
}

}  // namespace kelpie::gps
