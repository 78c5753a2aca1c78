// SPDX-License-Identifier: Apache-2.0
#include "actuator/walk/Feet.h"

#include "actuator/walk/Locus.h"
#include "robot/body/Legs.h"

namespace kelpie::actuator {
namespace {

// Where the ground that is below the body now was `before` seconds ago, seen from the body of then:
// turned about the middle of the way between.
Point2<Robot> groundBefore(Point2<Robot> at, const Velocity& v, double before) {
  const double turned = v.turn * before;
  const maths::SinCos whole = maths::sinCos(turned);
  const maths::SinCos half = maths::sinCos(0.5 * turned);
  const double lateral = -v.left * before;
  const double ahead = v.forward * before;
  return {whole.cos * at.x - whole.sin * at.y + half.cos * lateral - half.sin * ahead,
          whole.sin * at.x + whole.cos * at.y + half.sin * lateral + half.cos * ahead};
}

}  // namespace

Point3<Robot> footHome(LegId leg, const StanceParams& stance) {
  const bool left = leg == LegId::leftFront || leg == LegId::leftHind;
  const double lateral = body::isFront(leg) ? stance.frontLateral : stance.hindLateral;
  return {left ? -lateral : lateral, body::isFront(leg) ? stance.frontAhead : -stance.hindBehind,
          0.0};
}

Point3<Robot> footPlace(LegId leg, const WalkSet& set, const Velocity& velocity,
                        const PhaseState& phase) {
  const GaitParams& gait = set.gait;
  const bool front = body::isFront(leg);
  const double duty = front ? gait.frontDuty : gait.hindDuty;
  const LocusPoint at = locusPoint(gait.locus, footPhase(leg, gait, phase), duty, gait.lead);
  const double strokeSeconds = duty * 2.0 * gait.halfStepTicks * kTickSeconds;
  const double stretched = front ? 1.0 : gait.hindStroke;
  const Point3<Robot> home = footHome(leg, set.stance);
  const Point2<Robot> place =
      groundBefore({home.x, home.y}, velocity, 0.5 * at.along * strokeSeconds * stretched);
  const double lift = front ? gait.frontLift : gait.hindLift;
  return {place.x, place.y, phase.lift * lift * at.height};
}

void setLegs(const WalkSet& set, const Velocity& velocity, const PhaseState& phase,
             JointAngles& joints) {
  const body::Lean lean(Stance{set.stance.shoulderHeight, set.stance.bodyTilt, {}});
  for (std::size_t i = 0; i < kLegCount; ++i) {
    const auto leg = static_cast<LegId>(i);
    const Point3<Torso> foot = body::torsoFromRobot(lean, footPlace(leg, set, velocity, phase));
    body::setLegAngles(joints, leg, body::reachFoot(leg, foot).angles);
  }
}

}  // namespace kelpie::actuator
