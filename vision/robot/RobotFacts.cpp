// SPDX-License-Identifier: Apache-2.0
#include "vision/robot/RobotFacts.h"

#include "vision/LogOdds.h"

namespace kelpie::vision {
namespace {

constexpr double kPrior = -2.7;
constexpr std::array<Curve<RobotFacts>, 10> kCurves = {{
    {&RobotFacts::patches, {1, 2, 3, 5, 5, 5}, {0.54, -0.46, -1, -1.63, -1.63, -1.63}},
    {&RobotFacts::samples, {2, 3, 5, 11, 31, 259}, {1.77, 1.1, 0.43, -0.33, -0.27, -0.26}},
    {&RobotFacts::ownShare,
     {0.33, 0.5, 0.57, 0.78, 0.97, 1},
     {1.89, 1.47, 1.79, 1.02, 0.64, -0.29}},
    {&RobotFacts::meanIsOwn, {0, 1, 1, 1, 1, 1}, {-0.91, 0.03, 0.03, 0.03, 0.03, 0.03}},
    {&RobotFacts::patchWidth,
     {1.13, 2.43, 4.09, 5.77, 7.23, 12.71},
     {1.22, 0.41, 0.39, -0.14, -0.7, 2.18}},
    {&RobotFacts::patchHeight,
     {1.04, 2.63, 3.92, 4.53, 5.33, 10.31},
     {1.35, 1.52, -0.34, -0.94, 0.91, 2.95}},
    {&RobotFacts::heightError,
     {0.38, 2.31, 3.45, 4.49, 6.04, 10.02},
     {1.13, 0.41, -0.2, -0.45, 0.21, 2.19}},
    {&RobotFacts::carpetBeyond,
     {5.74, 11.31, 25.19, 111.96, 226.39, 300},
     {3.16, 4.82, 1.08, -0.09, -0.45, -0.1}},
    {&RobotFacts::footBelowEdge,
     {0.64, 0.98, 3.47, 9.41, 22.01, 40},
     {1.45, 1.18, 0.36, -0.2, -0.18, 0.15}},
    {&RobotFacts::footCut, {0, 1, 1, 1, 1, 1}, {-0.19, 2.26, 2.26, 2.26, 2.26, 2.26}},
}};

}  // namespace

double logOddsAgainst(const RobotFacts& facts) { return logOdds(kPrior, kCurves, facts); }

}  // namespace kelpie::vision
