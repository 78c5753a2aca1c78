// SPDX-License-Identifier: Apache-2.0
// Written by tools/curves from `kelpie evaluate doubts --trials 16000 --seed 62000000`; not to be
// edited by hand.
#include "vision/ball/BallCurves.h"

#include "vision/LogOdds.h"

namespace kelpie::vision {
namespace {

constexpr double kPrior = -7.49;
constexpr std::array<Curve<BallFacts>, 18> kCurves = {{
    {&BallFacts::range,
     {18.33, 88.12, 169.04, 244.95, 323.17, 410.29},
     {-0.88, 0.09, 0.01, 0.72, 0.89, 1.74}},
    {&BallFacts::radius,
     {1.97, 2.5, 3.29, 4.77, 9.16, 45.19},
     {1.74, 0.8, 0.59, 0.19, -0.35, -0.51}},
    {&BallFacts::edges, {5, 9, 11, 12, 15, 16}, {1.99, 1.86, 1.48, 2.26, 0.68, -0.63}},
    {&BallFacts::cut, {0, 1, 3, 5, 7, 9}, {-0.1, 0.26, -0.08, 0.36, 0.93, -0.21}},
    {&BallFacts::circleError,
     {0, 0.01, 0.02, 0.05, 0.05, 0.05},
     {-0.02, 0.73, 0.28, 0.33, 0.33, 0.33}},
    {&BallFacts::orange, {0.27, 0.63, 0.88, 0.96, 0.99, 1}, {2.13, 1.4, 0.75, 0.43, 0.73, -0.4}},
    {&BallFacts::otherColour,
     {0, 0.01, 0.04, 0.19, 0.43, 0.73},
     {0.07, -0.32, -0.41, 0.87, 0.96, 0.1}},
    {&BallFacts::green, {0, 0.01, 0.02, 0.05, 0.43, 0.43}, {-0.05, 0.62, 0.66, 0.77, 1.25, 1.25}},
    {&BallFacts::patch, {-1, -0.07, 0.07, 0.18, 0.56, 3}, {0.62, 0.04, -0.34, 0.2, 0.34, 1.31}},
    {&BallFacts::beside, {0, 0.08, 0.17, 0.25, 0.58, 0.58}, {-0.01, 1.29, 0.46, 0.78, 1.44, 1.44}},
    {&BallFacts::goalBelow, {0, 0.33, 0.67, 1, 1, 1}, {-0, 0.57, 0.09, 0.25, 0.25, 0.25}},
    {&BallFacts::carpetAround,
     {0, 0.14, 0.43, 0.71, 0.86, 1},
     {3.96, 3.69, 2.18, 0.81, 0.44, -0.38}},
    {&BallFacts::belowHorizon,
     {-1.15, 4.08, 7.63, 13.96, 28.27, 105.06},
     {1.52, 1.87, 0.68, 0.46, -0.66, -0.31}},
    {&BallFacts::edgeShows, {0, 1, 1, 1, 1, 1}, {0.34, -0.02, -0.02, -0.02, -0.02, -0.02}},
    {&BallFacts::footBelowEdge,
     {-1.85, -0.84, 0, 6.09, 19.49, 30},
     {1.05, 1.27, 0.3, 0.47, -0.38, -0.36}},
    {&BallFacts::footBelowInRadii,
     {-0.7, -0.26, 0, 1.44, 2.51, 4},
     {1.67, 1.42, 1.04, -1.45, 0.65, 0.84}},
    {&BallFacts::heightError,
     {-1.38, -0.05, 0.01, 0.11, 0.51, 1.77},
     {3.58, 0.16, -0.56, 0.53, 3.5, 3.82}},
    {&BallFacts::standsAlone, {0, 1, 1, 1, 1, 1}, {-0.11, 0.11, 0.11, 0.11, 0.11, 0.11}},
}};

}  // namespace

double logOddsAgainst(const BallFacts& facts) { return logOdds(kPrior, kCurves, facts); }

}  // namespace kelpie::vision
