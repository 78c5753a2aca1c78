// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/walk/WalkLearner.h"

#include <algorithm>
#include <cmath>

#include "robot/host/OnCores.h"
#include "tools/sim/physics/Variation.h"

namespace kelpie::learn {
namespace {

using actuator::WalkSet;

// One number of a set: where it is, and the range that is searched.
struct Knob {
  const char* name;
  double (*get)(const WalkSet&);
  void (*set)(WalkSet&, double);
  double min;
  double max;
};

#define KELPIE_KNOB(path) \
  [](const WalkSet& s) { return double{s.path}; }, [](WalkSet& s, double v) { s.path = v; }

const std::array<Knob, 19> kKnobs{{
    {"height", KELPIE_KNOB(stance.shoulderHeight), 7.0, 12.0},
    {"tilt", [](const WalkSet& s) { return s.stance.bodyTilt.deg(); },
     [](WalkSet& s, double v) { s.stance.bodyTilt = Angle::deg(v); }, 4.0, 20.0},
    {"frontAhead", KELPIE_KNOB(stance.frontAhead), -2.0, 8.0},
    {"frontLateral", KELPIE_KNOB(stance.frontLateral), 6.5, 11.0},
    {"hindBehind", KELPIE_KNOB(stance.hindBehind), 8.0, 17.0},
    {"hindLateral", KELPIE_KNOB(stance.hindLateral), 6.5, 11.0},
    {"halfStep", KELPIE_KNOB(gait.halfStepTicks), 16.0, 28.0},
    {"frontDuty", KELPIE_KNOB(gait.frontDuty), 0.38, 0.66},
    {"hindDuty", KELPIE_KNOB(gait.hindDuty), 0.38, 0.66},
    {"hindPhase", KELPIE_KNOB(gait.hindPhase), -0.15, 0.15},
    {"frontLift", KELPIE_KNOB(gait.frontLift), 0.6, 5.0},
    {"hindLift", KELPIE_KNOB(gait.hindLift), 0.6, 5.0},
    {"hindStroke", KELPIE_KNOB(gait.hindStroke), 0.6, 1.5},
    {"lead", KELPIE_KNOB(gait.lead), 0.0, 1.0},
    {"max.forward", KELPIE_KNOB(max.forward), 15.0, 90.0},
    {"max.back", KELPIE_KNOB(max.back), 15.0, 80.0},
    {"max.left", KELPIE_KNOB(max.left), 10.0, 60.0},
    {"max.turn", KELPIE_KNOB(max.turn), 1.0, 8.0},
    {"acceleration", KELPIE_KNOB(gait.acceleration), 40.0, 250.0},
}};

#undef KELPIE_KNOB

constexpr std::size_t kStanceKnobs = 6;  // the first

std::size_t firstKnob(WalkPart part) { return part == WalkPart::gait ? kStanceKnobs : 0; }

// Up to the aim each share counts whole, beyond it a twentieth.
double utility(double share) { return share <= 1.0 ? share : 1.0 + (share - 1.0) / 20.0; }

// A dribbling robot carries its front low, its front paws beside the ball (physics.md section 10);
// a low one stands a fifth lower than the normal walk, which is harder to push over.
struct Range {
  WalkKind kind;
  const char* name;
  double min;
  double max;
};
const std::array<Range, 6> kRanges{{{WalkKind::dribble, "height", 6.8, 8.6},
                                    {WalkKind::dribble, "tilt", 13.0, 24.0},
                                    {WalkKind::dribble, "frontAhead", 7.8, 10.0},
                                    {WalkKind::dribble, "frontLateral", 6.5, 7.4},
                                    {WalkKind::dribble, "hindBehind", 10.0, 16.0},
                                    {WalkKind::low, "height", 7.0, 8.5}}};

constexpr double kLostCosts = 4.0;  // of a dribbling walk that keeps no ball

// Of one direction over all models.
struct Over {
  double mean = 0.0;
  double min = 0.0;
  double spread = 0.0;  // standard deviation over the mean
};

Over over(const std::vector<double>& speeds) {
  Over result;
  const auto count = static_cast<double>(speeds.size());
  for (const double speed : speeds) result.mean += speed / count;
  double squares = 0.0;
  for (const double speed : speeds) squares += maths::square(speed - result.mean) / count;
  result.min = *std::min_element(speeds.begin(), speeds.end());
  result.spread = std::sqrt(squares) / std::max(1e-3, std::fabs(result.mean));
  return result;
}

}  // namespace

WalkAim aimOf(WalkKind kind) {
  WalkAim aim;
  if (kind == WalkKind::fast) {
    aim.speed[0] = 48.0;
    aim.weight = {3.0, 0.1, 0.3, 0.3};
  }
  if (kind == WalkKind::dribble) {
    aim.speed = {22.0, 10.0, 12.0, 2.4};
    aim.weight = {2.0, 0.3, 0.6, 2.0};
  }
  if (kind == WalkKind::turning) {
    aim.speed[3] = 5.0;
    aim.weight = {0.3, 0.3, 0.5, 3.0};
  }
  if (kind == WalkKind::back) {
    aim.speed[1] = 46.0;
    aim.weight = {0.3, 3.0, 0.5, 0.5};
  }
  if (kind == WalkKind::low) aim.speed = {32.0, 28.0, 24.0, 3.0};
  return aim;
}

SearchSpace walkSpace(WalkKind kind, WalkPart part, const WalkSet& start) {
  SearchSpace space;
  for (std::size_t k = firstKnob(part); k < kKnobs.size(); ++k) {
    const Knob& knob = kKnobs[k];
    space.names.emplace_back(knob.name);
    space.min.push_back(knob.min);
    space.max.push_back(knob.max);
    space.start.push_back(knob.get(start));
  }
  for (const Range& range : kRanges)
    for (std::size_t i = 0; i < space.names.size(); ++i)
      if (range.kind == kind && space.names[i] == range.name) {
        space.min[i] = range.min;
        space.max[i] = range.max;
      }
  return space;
}

WalkSet walkOf(const std::vector<double>& point, WalkPart part, const WalkSet& start) {
  WalkSet set = start;
  const std::size_t first = firstKnob(part);
  for (std::size_t i = 0; i < point.size(); ++i) kKnobs[first + i].set(set, point[i]);
  set.gait.turnAcceleration = 0.1 * set.gait.acceleration;
  set.calibration = {};
  set.odometry = actuator::exactOdometry();
  return set;
}

std::vector<sim::PhysicsParams> variedModels(std::uint64_t seed, int count, double step) {
  std::vector<sim::PhysicsParams> models;
  for (int i = 0; i < count; ++i) {
    models.push_back(sim::varied({}, seed + static_cast<std::uint64_t>(i)));
    models.back().step = step;
  }
  return models;
}

std::vector<WalkTrial> tryOnAll(const WalkTrialPlan& plan, const WalkSet& set,
                                const std::vector<sim::PhysicsParams>& models, std::uint64_t seed) {
  actuator::ActuatorParams params;
  actuator::walkSet(params.walks, plan.kind) = set;
  std::vector<WalkTrial> trials(models.size());
  host::onCores(models.size(),
                [&](std::size_t i) { trials[i] = tryWalk(plan, models[i], params, seed + i); });
  return trials;
}

double gainOf(const std::vector<WalkTrial>& trials, const WalkAim& aim) {
  double gain = 0.0;
  const auto count = static_cast<double>(trials.size());
  for (std::size_t way = 0; way < kWalkDirections; ++way) {
    std::vector<double> whole;
    std::vector<double> half;
    for (const WalkTrial& trial : trials) {
      whole.push_back(trial.speed[way]);
      half.push_back(trial.half[way]);
    }
    const Over full = over(whole);
    const Over less = over(half);
    gain += aim.weight[way] * utility(0.5 * (full.mean + full.min) / aim.speed[way]);
    const double uneven = 2.0 * less.mean / std::max(1e-3, full.mean) - 1.0;
    // A walk that hardly goes yet shall first learn to go.
    const double spread = std::min(1.0, full.spread + less.spread);
    gain -= aim.weight[way] *
            (aim.spreadCosts * spread + aim.unevenCosts * std::min(1.0, std::fabs(uneven)));
  }
  for (const WalkTrial& trial : trials) {
    const double costs =
        aim.bendCosts * std::min(trial.bend, 0.01) + aim.oscillationCosts * trial.oscillation;
    gain -= (trial.fell ? 1.0 : 0.0) + (costs + kLostCosts * trial.lost) / count;
  }
  return gain;
}

}  // namespace kelpie::learn
