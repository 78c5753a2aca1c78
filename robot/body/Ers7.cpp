// SPDX-License-Identifier: Apache-2.0
#include "robot/body/Ers7.h"

namespace kelpie::body {
namespace {

// Up to `rotator` degrees from the middle the shoulder may go down to `lowest`.
struct Step {
  double rotator;
  double lowest;
};

// By the manual's table of the two joints (openr.md 5.6), whose rows for hind legs are in the
// robot's sign: positive is backward there.
constexpr std::array<Step, 9> kFrontAhead = {
    {{20, -10}, {25, -9}, {30, -8}, {40, -7}, {45, -6}, {50, -5}, {55, -4}, {65, -3}, {180, -2}}};
constexpr std::array<Step, 10> kFrontBehind = {{{10, -10},
                                                {15, -9},
                                                {20, -8},
                                                {25, -7},
                                                {30, -6},
                                                {35, -5},
                                                {45, -4},
                                                {55, -3},
                                                {75, -2},
                                                {180, -1}}};
constexpr std::array<Step, 11> kHindBehind = {{{15, -10},
                                               {20, -9},
                                               {25, -8},
                                               {30, -7},
                                               {35, -6},
                                               {40, -5},
                                               {45, -4},
                                               {50, -3},
                                               {60, -2},
                                               {70, -1},
                                               {180, 0}}};
constexpr std::array<Step, 11> kHindAhead = {{{10, -10},
                                              {15, -9},
                                              {20, -8},
                                              {25, -7},
                                              {30, -6},
                                              {35, -5},
                                              {40, -4},
                                              {45, -3},
                                              {55, -2},
                                              {70, -1},
                                              {180, 0}}};

template <class Steps>
double lowestAt(const Steps& steps, double rotator) {
  for (const Step& step : steps)
    if (rotator <= step.rotator) return step.lowest;
  return steps.back().lowest;
}

}  // namespace

double lowestShoulder(LegId leg, double rotator) {
  const bool front = leg == LegId::leftFront || leg == LegId::rightFront;
  if (front)
    return rotator >= 0 ? lowestAt(kFrontAhead, rotator) : lowestAt(kFrontBehind, -rotator);
  return rotator >= 0 ? lowestAt(kHindAhead, rotator) : lowestAt(kHindBehind, -rotator);
}

JointGain withShare(JointGain gain, double share) {
  const double p = maths::clamp(share * gain.p + 0.5, 1.0, 255.0);
  return {static_cast<std::uint8_t>(p), gain.i, gain.d};
}

JointGain gainOf(Joint joint, LegGain legs) {
  switch (joint) {
    case Joint::neckTilt: return kNeckTiltGain;
    case Joint::headPan: return kHeadPanGain;
    case Joint::headNod: return kHeadNodGain;
    case Joint::mouth: return kMouthGain;
    case Joint::tailTilt:
    case Joint::tailPan: return kTailGain;
    default: break;
  }
  const bool shoulder = (index(joint) - index(Joint::leftFrontRotator)) % 3 == 1;
  if (legs.low) return shoulder ? kWeakShoulderGain : kWeakLegGain;
  return withShare(shoulder ? kShoulderGain : kLegGain, legs.share);
}

double meanOf(LegGain legs) {
  double sum = 0.0;
  for (std::size_t j = index(Joint::leftFrontRotator); j <= index(Joint::rightHindKnee); ++j) {
    const auto joint = static_cast<Joint>(j);
    const double gain = gainOf(joint, legs).p;
    sum += gain / gainOf(joint, {}).p;
  }
  return sum / (3 * kLegCount);
}

}  // namespace kelpie::body
