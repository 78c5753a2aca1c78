// SPDX-License-Identifier: Apache-2.0
// Written by tools/curves from `kelpie evaluate doubts --trials 16000 --seed 62000000`; not to be
// edited by hand.
#include "vision/beacon/BeaconCurves.h"

#include "vision/LogOdds.h"

namespace kelpie::vision {
namespace {

constexpr double kPrior = -6.58;
constexpr std::array<Curve<BeaconFacts>, 18> kCurves = {{
    {&BeaconFacts::distance,
     {45.48, 84.55, 128.03, 247.12, 340.56, 463.4},
     {0.71, 0.53, -0.22, 0.3, -0.54, 0.72}},
    {&BeaconFacts::band,
     {4.48, 6.18, 8.6, 16.51, 25.38, 46.07},
     {0.7, -0.37, 0, -0.08, 0.35, 0.66}},
    {&BeaconFacts::bandRatio,
     {0, 0.01, 0.03, 0.06, 0.24, 1.38},
     {0.41, -0.11, -0.99, 0.68, 0.15, 2.59}},
    {&BeaconFacts::aspect,
     {-2.45, -1.42, -0.78, -0.08, -0.01, 0.25},
     {2.73, 3.28, 2.77, 0.59, -1.02, 1.64}},
    {&BeaconFacts::wider, {0, 0.03, 0.07, 0.53, 1, 2.52}, {-0.25, -0.02, 0.02, 0.22, 1.22, 1.66}},
    {&BeaconFacts::elevationError,
     {0.01, 0.08, 0.18, 0.4, 0.91, 1.61},
     {0.05, -0.44, 0.21, 0.32, 2.16, 2.2}},
    {&BeaconFacts::belowHorizon,
     {-55.35, -31.33, -21.53, -11.75, -8.31, -4.79},
     {0.17, 1.52, 0.36, 0.28, -0.74, 0.44}},
    {&BeaconFacts::whiteShare,
     {0, 0.04, 0.32, 0.54, 0.97, 1},
     {2.59, 2.69, 2.35, 2.22, 0.44, -0.18}},
    {&BeaconFacts::whiteShows, {0, 0.3, 0.56, 0.95, 1, 1}, {-0.75, 0.82, 0.04, 0.27, -0, -0}},
    {&BeaconFacts::edgeShows, {0, 1, 1, 1, 1, 1}, {0.09, -0, -0, -0, -0, -0}},
    {&BeaconFacts::footBelowEdge,
     {-0.99, 0.04, 0.14, 0.55, 1.32, 1.64},
     {3.6, -0.05, -0.25, 0.65, 4.04, 2.47}},
    {&BeaconFacts::strangeBelow,
     {0, 0.03, 0.09, 0.17, 0.34, 1.34},
     {-0.04, 0.4, 0.41, 1.06, 1.39, 1.14}},
    {&BeaconFacts::filled,
     {0.48, 0.75, 0.88, 0.95, 0.98, 1},
     {3.97, 2.78, 0.25, 0.36, 0.16, -0.38}},
    {&BeaconFacts::beside, {0, 0.08, 0.25, 0.33, 0.5, 0.67}, {-0.14, 0.64, 1.13, 0.48, 1.87, 0.61}},
    {&BeaconFacts::onWhite, {0, 1, 1, 1, 1, 1}, {0.7, -0.13, -0.13, -0.13, -0.13, -0.13}},
    {&BeaconFacts::topCut, {0, 1, 1, 1, 1, 1}, {0.04, -0.31, -0.31, -0.31, -0.31, -0.31}},
    {&BeaconFacts::bottomCut, {0, 1, 1, 1, 1, 1}, {-0.02, 1.15, 1.15, 1.15, 1.15, 1.15}},
    {&BeaconFacts::widthCut, {0, 1, 1, 1, 1, 1}, {0.11, -2.85, -2.85, -2.85, -2.85, -2.85}},
}};

}  // namespace

double logOddsAgainst(const BeaconFacts& facts) { return logOdds(kPrior, kCurves, facts); }

}  // namespace kelpie::vision
