// SPDX-License-Identifier: Apache-2.0
// What the legs feel of something that holds the body, a hand, another robot or a wall: the feet
// that stand grip the carpet, so that part of the way which the body does not go is not gone by the
// joints either. They fall behind their targets, and the duty of their motors rises. Erratic, as
// thesis 2004 section 2.2.4 found it: how well the feet grip differs from step to step. Its random
// numbers are its own: a robot that nothing holds walks as it would without.
#pragma once

#include "robot/core/Random.h"
#include "robot/core/fields/Fields.h"
#include "robot/core/types/Geometry.h"

namespace kelpie::sim {

struct ResistanceParams {
  double grip = 0.6;         // share of a way not gone that holds the joints back; the rest slips
  double gripSd = 0.2;       // its spread from step to step
  double settleTicks = 4.0;  // of what is felt of a push
  double dutyNoise = 0.03;   // sd of every motor's duty

  template <int = 0>
  static constexpr auto fields() {
    using P = ResistanceParams;
    return fieldList(field("grip", &P::grip, "", 0, 0.95), field("gripSd", &P::gripSd, "", 0, 1),
                     field("settleTicks", &P::settleTicks, "", 0.1, 100),
                     field("dutyNoise", &P::dutyNoise, "", 0, 1));
  }
};

class Resistance {
 public:
  Resistance(const ResistanceParams& params, std::uint64_t seed) : params_(params), random_(seed) {
    newStep();
  }

  // Somebody takes this share of all that the body would move.
  void hold(double share) { held_ = maths::clamp(share, 0.0, 1.0); }
  double held() const { return held_; }

  // What the body went by itself in a tick, and by how much it was pushed.
  void feel(Point2<Field> walked, Point2<Field> pushed);
  // A foot came down.
  void newStep();
  // By which share the joints of standing legs are slowed, 0 to 0.95.
  double slowed() const { return grip_ * (pushedBack_ > held_ ? pushedBack_ : held_); }
  double dutyNoise() { return random_.gaussian(0.0, params_.dutyNoise); }

 private:
  ResistanceParams params_;
  Random random_;
  double held_ = 0.0;
  double pushedBack_ = 0.0;  // share of the way, a running mean
  double grip_ = 0.0;
};

}  // namespace kelpie::sim
