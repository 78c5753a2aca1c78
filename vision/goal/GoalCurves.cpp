// SPDX-License-Identifier: Apache-2.0
// Learned by `kelpie evaluate doubts` from candidates of 60 000 views of bodies that do not lean.
#include "vision/goal/GoalCurves.h"

#include "vision/LogOdds.h"

namespace kelpie::vision {
namespace {

constexpr double kPrior = -5.43;
constexpr std::array<Curve<GoalFacts>, 22> kCurves = {{
    {&GoalFacts::wallDistance,
     {84.17, 203.7, 297.33, 373.43, 457.81, 546.95},
     {2.59, 0.44, -0.59, -0.06, -0.67, -0.07}},
    {&GoalFacts::visibleWidth,
     {16.85, 24.52, 38.52, 59.87, 79.71, 131.98},
     {2.74, 2.59, 1.48, -0.56, -0.53, -0.48}},
    {&GoalFacts::width, {10, 22, 32, 44, 61.25, 146.67}, {-1.83, 0.07, 0.4, 0.22, 0.1, -1.27}},
    {&GoalFacts::lowestFoot,
     {-1.46, -0.57, 0.09, 0.51, 2.29, 20},
     {2.17, 1.66, -0.89, -0.32, 0.98, 1.66}},
    {&GoalFacts::meanFoot,
     {-3.15, -1.1, -0.36, -0.04, 0.3, 20},
     {4.29, 1.63, 0.55, 0.24, -1.1, -0.07}},
    {&GoalFacts::footError,
     {0, 0.03, 0.09, 0.19, 0.46, 1.68},
     {0.71, -0.01, -0.59, -0.02, 0.43, 3.63}},
    {&GoalFacts::misfit, {0, 0.05, 0.23, 1.32, 8.72, 50}, {-0.23, -0.68, 0.08, 0.69, 1.19, 2.16}},
    // A single column fits any shape and noise may end it: this leaves out six of 26 false goals in
    // 12 000 randomised views and 0.2 % of those to be seen.
    {&GoalFacts::measured, {1, 2, 6, 13, 17, 24}, {3.94, 2.15, 0.99, -0.29, 0.03, -1.14}},
    {&GoalFacts::chosen, {5, 9, 12, 15, 19, 24}, {2.31, 1.43, 1.27, 0.62, -0.5, -1.61}},
    {&GoalFacts::coloured,
     {0.42, 0.74, 0.86, 0.94, 1.12, 2.16},
     {0.98, -0.24, 0.48, -0.11, -0.36, -0.67}},
    // In randomised worlds 98 % of the goals to be seen have over 0.87, four in ten of the false
    // less.
    {&GoalFacts::paint, {0.83, 0.85, 0.87, 0.9, 1, 1}, {5, 4, 2, 0, 0, 0}},
    {&GoalFacts::green, {0.38, 0.67, 0.79, 0.88, 0.96, 1}, {-2.29, -0.78, -0.79, 0.09, 0.93, 0.73}},
    {&GoalFacts::hidden, {0, 1, 2, 2, 2, 2}, {-0.08, 0.62, 1.23, 1.23, 1.23, 1.23}},
    {&GoalFacts::cut, {0, 1, 2, 2, 2, 2}, {-0.09, 0.14, 1.21, 1.21, 1.21, 1.21}},
    {&GoalFacts::topCut, {0, 1, 1, 1, 1, 1}, {-0.11, 0.2, 0.2, 0.2, 0.2, 0.2}},
    {&GoalFacts::lateralOffset,
     {3.32, 35.16, 72.48, 130.79, 228.86, 524.51},
     {-0.16, 0.84, -0.13, -0.53, 0.19, 0.43}},
    {&GoalFacts::edgeDistance,
     {-187.14, -34.86, -7.7, 1.34, 33.2, 200},
     {3.9, 0.3, -0.47, -0.11, -0.18, 2.32}},
    {&GoalFacts::edgeTurn,
     {0, 3.32, 11.08, 28.24, 56.65, 87.13},
     {0.51, -0.63, 0.01, -0.15, 1.2, 1.41}},
    {&GoalFacts::edgeLateralOffset,
     {0, 25.55, 60.16, 94.99, 147.47, 336.31},
     {0.63, 0.22, -0.06, -0.2, -0.49, 1.31}},
    {&GoalFacts::cornerError,
     {0, 0.95, 13.66, 38.21, 82.18, 212.7},
     {0.32, -1.37, -1.3, 0.22, 1.57, 2.59}},
    {&GoalFacts::beaconError,
     {0, 0.29, 5.79, 63.35, 228.02, 396.81},
     {1.09, -1.3, -2.35, 1.2, 2.89, 1.65}},
    {&GoalFacts::offCarpetDistance,
     {0, 7.81, 91.39, 159.98, 222.13, 336.26},
     {-0.01, 1.9, 3.46, 4.75, 4.63, 3.87}},
}};

}  // namespace

double logOddsAgainst(const GoalFacts& facts) { return logOdds(kPrior, kCurves, facts); }

}  // namespace kelpie::vision
