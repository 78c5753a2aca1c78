// SPDX-License-Identifier: Apache-2.0
// Written by tools/curves from `kelpie evaluate doubts --trials 16000 --seed 62000000`; not to be
// edited by hand.
#include "vision/ball/BallCurves.h"

#include "vision/LogOdds.h"

namespace kelpie::vision {
namespace {

constexpr double kPrior = -6.45;
constexpr std::array<Curve<BallFacts>, 18> kCurves = {{
    {&BallFacts::range,
     {17.99, 82.22, 141.85, 209.99, 279.45, 395.7},
     {-0.85, 0.1, 0.11, 0.3, 0.35, 1.47}},
    {&BallFacts::radius,
     {2.04, 2.89, 3.84, 5.69, 9.82, 46.11},
     {1.34, 0.38, 0.29, 0.05, -0.22, -0.62}},
    {&BallFacts::edges, {5, 8, 10, 11, 15, 16}, {2.95, 2.22, 1.72, 1.67, 1.03, -0.8}},
    {&BallFacts::cut, {0, 1, 3, 5, 7, 9}, {-0.14, 0.26, 0.16, 0.2, 0.89, 0.24}},
    {&BallFacts::circleError,
     {0, 0.01, 0.02, 0.04, 0.04, 0.04},
     {-0.05, 1.62, 0.58, 0.6, 0.6, 0.6}},
    {&BallFacts::orange, {0.38, 0.81, 0.92, 0.96, 0.99, 1}, {1.55, 1.78, 1.07, 0.06, 0.25, -0.28}},
    {&BallFacts::otherColour,
     {0, 0.01, 0.02, 0.05, 0.14, 0.34},
     {0.11, -0.55, -0.5, -0.3, -0.22, 0.36}},
    {&BallFacts::green, {0, 0.01, 0.02, 0.05, 0.17, 0.17}, {-0.01, 0.12, -0.06, 0.61, 1.62, 1.62}},
    {&BallFacts::patch,
     {-1.24, -0.03, 0.09, 0.22, 0.69, 2.98},
     {1.73, -0.35, -0.14, 0.07, 1.45, 0.93}},
    {&BallFacts::beside, {0, 0.08, 0.17, 0.25, 0.5, 0.5}, {-0.03, 1.11, 1.31, 1.82, 1.54, 1.54}},
    {&BallFacts::goalBelow, {0, 0.33, 0.67, 0.67, 0.67, 0.67}, {-0, 2.58, 0.95, 0.95, 0.95, 0.95}},
    {&BallFacts::carpetAround,
     {0.14, 0.43, 0.57, 0.71, 0.86, 1},
     {2.7, 1.6, 1.21, 0.17, 0.09, -0.2}},
    {&BallFacts::belowHorizon,
     {0.86, 5.44, 8.51, 13.55, 26.77, 108.58},
     {0.46, 0.36, 0.62, 0.63, -0.57, -0.45}},
    {&BallFacts::edgeShows, {0, 1, 1, 1, 1, 1}, {-0.71, 0.04, 0.04, 0.04, 0.04, 0.04}},
    {&BallFacts::footBelowEdge,
     {-1.87, -0.97, 0, 4.3, 17.44, 30},
     {1.39, 2.25, 0.05, -0, -0.32, 0.16}},
    {&BallFacts::footBelowInRadii,
     {-0.66, -0.24, 0, 1.1, 2.29, 3.78},
     {1.91, 2.89, 1.97, -0.58, -0.72, 1.25}},
    {&BallFacts::heightError,
     {-0.39, -0.06, 0.07, 0.22, 0.59, 1.78},
     {2.45, -0.98, -0.02, 0.81, 2.14, 3.43}},
    {&BallFacts::standsAlone, {0, 1, 1, 1, 1, 1}, {-0.38, 0.03, 0.03, 0.03, 0.03, 0.03}},
}};

}  // namespace

double logOddsAgainst(const BallFacts& facts) { return logOdds(kPrior, kCurves, facts); }

}  // namespace kelpie::vision
