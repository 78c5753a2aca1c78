// SPDX-License-Identifier: Apache-2.0
// Stands in for a robot's vision: percepts of the true scene, as its camera has it, with what
// vision misses and mistakes (EyeNoise.h). The robot gets these and nothing else of the truth.
#pragma once

#include <memory>

#include "robot/agent/loops/Sight.h"
#include "robot/body/FieldDescription.h"
#include "robot/core/Random.h"
#include "tools/percepts/EyeNoise.h"
#include "tools/percepts/View.h"

namespace kelpie::percepts {

class Eye : public agent::Sight {
 public:
  Eye(const body::FieldDescription& field, std::size_t robot, std::uint64_t seed,
      const EyeNoise& noise = {})
      : field_(field), robot_(robot), noise_(noise), random_(seed) {}

  // What the next image shows; must live until it was seen.
  void show(const Moment& moment) { moment_ = &moment; }
  void see(const FrameInput& input, const BodyState& body, Percepts& percepts) override;

 private:
  body::FieldDescription field_;
  std::size_t robot_;
  EyeNoise noise_;
  Random random_;
  View view_;
  const Moment* moment_ = nullptr;
};

// What the finders of an eye have in common.
struct Look {
  const View& view;
  const Moment& moment;
  const body::FieldDescription& field;
  const BodyState& body;
  const EyeNoise& noise;
  Random& random;
};

void seeBall(const Look& look, BallPercept& ball);
void seeBeacons(const Look& look, Percepts& percepts);
void seeGoals(const Look& look, Percepts& percepts);
void seeRobots(const Look& look, Percepts& percepts);
void seeObstacles(const Look& look, Percepts& percepts);
void seeFieldEdges(const Look& look, Percepts& percepts);
// Not where ball and robots of the same percepts are.
void seeLines(const Look& look, Percepts& percepts);

// Of something of which that share shows.
double recallOf(const RecallByShare& recall, double shown);
// What is not there.
void seeFalseOnes(const Look& look, Percepts& percepts);

// How much higher a thing is read than it would stand at a distance, with the variance that is said
// of it.
ElevationError elevationErrorAt(const Look& look, PixelPoint pixel, double height, double distance,
                                double variance);

}  // namespace kelpie::percepts
