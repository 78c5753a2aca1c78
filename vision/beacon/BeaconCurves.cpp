// SPDX-License-Identifier: Apache-2.0
// Written by tools/curves from `kelpie evaluate doubts --trials 16000 --seed 62000000`; not to be
// edited by hand.
#include "vision/beacon/BeaconCurves.h"

#include "vision/LogOdds.h"

namespace kelpie::vision {
namespace {

constexpr double kPrior = -6.41;
constexpr std::array<Curve<BeaconFacts>, 18> kCurves = {{
    {&BeaconFacts::distance,
     {44.1, 119.68, 206.86, 287.52, 358.16, 474.4},
     {0.5, 0.3, 0.17, 0.44, -0.77, 0.29}},
    {&BeaconFacts::band,
     {4.39, 5.82, 7.31, 10.31, 18.02, 46.52},
     {0.48, 0.5, -0.42, -0.41, -0.21, 0.37}},
    {&BeaconFacts::bandRatio,
     {0, 0.01, 0.03, 0.07, 0.35, 2},
     {0.68, -0.56, -0.58, 0.47, 1.08, 3.92}},
    {&BeaconFacts::aspect,
     {-2.27, -1.12, -0.34, -0.06, 0.01, 0.58},
     {2.82, 2.91, 2.15, -0.15, -0.63, 3.84}},
    {&BeaconFacts::wider,
     {0, 0.02, 0.06, 0.4, 0.97, 2.92},
     {-0.46, 0.15, -0.02, -0.34, 1.69, 1.79}},
    {&BeaconFacts::elevationError,
     {0.01, 0.17, 0.33, 0.57, 0.96, 1.62},
     {-0.68, -0.14, 0.22, 0.02, 1.53, 2.12}},
    {&BeaconFacts::belowHorizon,
     {-58.07, -25.38, -15.62, -10.91, -8, -3.84},
     {0.36, 0.53, 0.08, 0.48, -0.76, 0.44}},
    {&BeaconFacts::whiteShare,
     {0, 0.09, 0.5, 0.67, 0.97, 1},
     {2.51, 2.24, 2.15, 1.96, -0.18, -0.11}},
    {&BeaconFacts::whiteShows, {0, 0.2, 0.59, 0.94, 1, 1}, {-0.79, 0.23, 0.5, -0.1, 0, 0}},
    {&BeaconFacts::edgeShows, {0, 1, 1, 1, 1, 1}, {0.95, -0.03, -0.03, -0.03, -0.03, -0.03}},
    {&BeaconFacts::footBelowEdge,
     {-2.16, -0.04, 0.04, 0.13, 0.28, 0.91},
     {4.2, 0.65, -0.14, -0.52, 0.52, 2.32}},
    {&BeaconFacts::strangeBelow,
     {0, 0.03, 0.14, 0.24, 0.55, 2.08},
     {-0.06, 1.26, 0.74, 2.61, 2.67, 1.56}},
    {&BeaconFacts::filled,
     {0.35, 0.73, 0.85, 0.95, 0.98, 1},
     {4.23, 2.41, 1.08, 0.64, -0.02, -0.52}},
    {&BeaconFacts::beside,
     {0, 0.08, 0.25, 0.27, 0.45, 0.67},
     {-0.15, 0.92, 1.22, -0.44, 1.58, 0.86}},
    {&BeaconFacts::onWhite, {0, 1, 1, 1, 1, 1}, {0.53, -0.1, -0.1, -0.1, -0.1, -0.1}},
    {&BeaconFacts::topCut, {0, 1, 1, 1, 1, 1}, {-0.1, 0.86, 0.86, 0.86, 0.86, 0.86}},
    {&BeaconFacts::bottomCut, {0, 1, 1, 1, 1, 1}, {-0.02, 0.71, 0.71, 0.71, 0.71, 0.71}},
    {&BeaconFacts::widthCut, {0, 1, 1, 1, 1, 1}, {0.09, -2.43, -2.43, -2.43, -2.43, -2.43}},
}};

}  // namespace

double logOddsAgainst(const BeaconFacts& facts) { return logOdds(kPrior, kCurves, facts); }

}  // namespace kelpie::vision
