// SPDX-License-Identifier: Apache-2.0
// Physical robots that differ as real ones might: what is tuned on one model alone is brittle
// (physics.md section 4). How far they differ is chosen as there.
#pragma once

#include "robot/core/Random.h"
#include "tools/sim/physics/PhysicsParams.h"

namespace kelpie::sim {

constexpr double kMaxPlay = 0.015;  // rad, in a leg's gears [chosen]

// That model with friction, armature, contact, servo, mass and the play of the legs' gears drawn
// about its own.
inline PhysicsParams varied(PhysicsParams params, std::uint64_t seed) {
  Random random(seed);
  params.contact.carpet *= random.uniform(0.75, 1.25);
  params.servo.armature *= random.uniform(0.7, 1.5);
  params.contact.time *= random.uniform(0.75, 1.2);
  const double strength = random.uniform(0.92, 1.05);
  for (Servo* servo : {&params.servo.leg, &params.servo.neckTilt, &params.servo.headPan,
                       &params.servo.headNod, &params.servo.mouth}) {
    servo->stall *= strength;
    servo->kp *= strength;
  }
  const double weight = random.uniform(0.92, 1.1);
  for (double* mass : {&params.mass.trunk, &params.mass.neck, &params.mass.head, &params.mass.jaw,
                       &params.mass.upperLeg, &params.mass.lowerLeg})
    *mass *= weight;
  params.servo.legPlay += random.uniform(0.0, kMaxPlay);
  return params;
}

}  // namespace kelpie::sim
