// SPDX-License-Identifier: Apache-2.0
// Written by tools/curves from `kelpie evaluate doubts --trials 16000 --seed 62000000`; not to be
// edited by hand.
#include "vision/robot/RobotCurves.h"

#include "vision/LogOdds.h"

namespace kelpie::vision {
namespace {

constexpr double kPrior = -2.02;
constexpr std::array<Curve<RobotFacts>, 10> kCurves = {{
    {&RobotFacts::patches, {1, 2, 3, 5, 5, 5}, {0.57, -0.46, -0.6, -1.4, -1.4, -1.4}},
    {&RobotFacts::samples, {2, 3, 4, 9, 24, 215}, {2.29, 0.32, 0.19, -0.4, -0.27, 0.51}},
    {&RobotFacts::ownShare,
     {0.33, 0.5, 0.64, 0.76, 0.94, 1},
     {2.27, 0.61, 0.68, 0.47, -0.52, -0.2}},
    {&RobotFacts::meanIsOwn, {0, 1, 1, 1, 1, 1}, {0.44, -0.02, -0.02, -0.02, -0.02, -0.02}},
    {&RobotFacts::patchWidth,
     {1.08, 2.6, 4.15, 5.82, 7.28, 15.53},
     {2.03, 0.11, 0.31, -0.31, -0.39, 2.05}},
    {&RobotFacts::patchHeight,
     {1.17, 2.78, 3.92, 4.68, 5.95, 13.08},
     {1.61, 0.39, -0.62, -0.79, 1.99, 3.3}},
    {&RobotFacts::heightError,
     {0.26, 2, 3.22, 4.32, 5.98, 11.03},
     {0.81, 0.22, -0.29, -0.51, 0.37, 1.12}},
    {&RobotFacts::carpetBeyond,
     {5.65, 12.17, 27.16, 102.13, 214.53, 300},
     {2.97, 3.16, 0.12, 0.02, -0.28, -0.05}},
    {&RobotFacts::footBelowEdge,
     {0.62, 0.84, 2.46, 8.2, 19.6, 40},
     {2.22, 2.68, 1.26, -0.31, -0.41, 0.02}},
    {&RobotFacts::footCut, {0, 1, 1, 1, 1, 1}, {-0.12, 1.91, 1.91, 1.91, 1.91, 1.91}},
}};

}  // namespace

double logOddsAgainst(const RobotFacts& facts) { return logOdds(kPrior, kCurves, facts); }

}  // namespace kelpie::vision
