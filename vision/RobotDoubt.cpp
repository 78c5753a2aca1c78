// SPDX-License-Identifier: Apache-2.0
#include "vision/RobotDoubt.h"

#include "vision/LogOdds.h"

namespace kelpie::vision {
namespace {

constexpr double kNear = 100.0;  // cm: the image often cuts the feet of nearer robots
constexpr double kPrior = 8.75;

constexpr std::array<Weight<RobotFacts>, 14> kWeights = {{
    {&RobotFacts::patches, 2.0, -1.8},
    {&RobotFacts::width, 2.4, -1.5},
    {&RobotFacts::own, 0.82, -1.3},
    {&RobotFacts::shell, 0.75, -1.1, Range::far},
    {&RobotFacts::patchWidth, 8.3, 1.4},
    {&RobotFacts::patchHeight, 3.1, -1.9},
    {&RobotFacts::patchHeight, 5.5, 2.3},
    {&RobotFacts::heightOff, 2.0, -1.1},
    {&RobotFacts::heightOff, 6.1, 1.6},
    {&RobotFacts::beyond, 26.0, -2.3},
    {&RobotFacts::inside, 5.5, -1.2},
    {&RobotFacts::behind, 8.0, -0.9},
    {&RobotFacts::footCut, 1.0, 1.6, Range::near},
    {&RobotFacts::edges, 1.0, -2.0},
}};

}  // namespace

double robotDoubt(const RobotFacts& facts) {
  return logOdds(kPrior, kWeights, facts, facts.distance < kNear);
}

}  // namespace kelpie::vision
