// SPDX-License-Identifier: Apache-2.0
#include "tools/learn/WalkLearner.h"

#include <algorithm>
#include <future>
#include <thread>

#include "tools/sim/physics/Variation.h"

namespace kelpie::learn {
namespace {

using actuator::WalkSet;

// One number of a set: where it is, and the range that is searched.
struct Knob {
  const char* name;
  double (*get)(const WalkSet&);
  void (*set)(WalkSet&, double);
  double least;
  double most;
};

#define KELPIE_KNOB(path) \
  [](const WalkSet& s) { return double{s.path}; }, [](WalkSet& s, double v) { s.path = v; }

const std::array<Knob, 19> kKnobs{{
    {"height", KELPIE_KNOB(stance.shoulderHeight), 7.0, 12.0},
    {"tilt", [](const WalkSet& s) { return s.stance.bodyTilt.deg(); },
     [](WalkSet& s, double v) { s.stance.bodyTilt = Angle::deg(v); }, 4.0, 20.0},
    {"frontAhead", KELPIE_KNOB(stance.frontAhead), -2.0, 8.0},
    {"frontAside", KELPIE_KNOB(stance.frontAside), 6.5, 11.0},
    {"hindBehind", KELPIE_KNOB(stance.hindBehind), 8.0, 17.0},
    {"hindAside", KELPIE_KNOB(stance.hindAside), 6.5, 11.0},
    {"halfStep", KELPIE_KNOB(gait.halfStepTicks), 16.0, 28.0},
    {"frontDuty", KELPIE_KNOB(gait.frontDuty), 0.38, 0.66},
    {"hindDuty", KELPIE_KNOB(gait.hindDuty), 0.38, 0.66},
    {"hindPhase", KELPIE_KNOB(gait.hindPhase), -0.15, 0.15},
    {"frontLift", KELPIE_KNOB(gait.frontLift), 0.6, 5.0},
    {"hindLift", KELPIE_KNOB(gait.hindLift), 0.6, 5.0},
    {"hindStroke", KELPIE_KNOB(gait.hindStroke), 0.6, 1.5},
    {"lead", KELPIE_KNOB(gait.lead), 0.0, 1.0},
    {"most.forward", KELPIE_KNOB(most.forward), 15.0, 90.0},
    {"most.back", KELPIE_KNOB(most.back), 15.0, 80.0},
    {"most.left", KELPIE_KNOB(most.left), 10.0, 60.0},
    {"most.turn", KELPIE_KNOB(most.turn), 1.0, 8.0},
    {"acceleration", KELPIE_KNOB(gait.acceleration), 40.0, 250.0},
}};

#undef KELPIE_KNOB

// Up to the aim each share counts whole, beyond it a third.
double worth(double share) { return share <= 1.0 ? share : 1.0 + (share - 1.0) / 3.0; }

}  // namespace

WalkAim aimOf(WalkKind kind) {
  WalkAim aim;
  if (kind == WalkKind::fast) {
    aim.speed[0] = 48.0;
    aim.weight = {3.0, 0.1, 0.3, 0.3};
  }
  if (kind == WalkKind::turning) aim.weight = {0.3, 0.3, 0.5, 3.0};
  if (kind == WalkKind::back) aim.weight = {0.3, 3.0, 0.5, 0.5};
  return aim;
}

SearchSpace walkSpace(const WalkSet& start) {
  SearchSpace space;
  for (const Knob& knob : kKnobs) {
    space.names.emplace_back(knob.name);
    space.least.push_back(knob.least);
    space.most.push_back(knob.most);
    space.start.push_back(knob.get(start));
  }
  return space;
}

WalkSet walkOf(const std::vector<double>& point, const WalkSet& start) {
  WalkSet set = start;
  for (std::size_t i = 0; i < kKnobs.size(); ++i) kKnobs[i].set(set, point[i]);
  set.gait.turnAcceleration = 0.1 * set.gait.acceleration;
  set.calibration = {};
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
  const std::size_t workers = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::future<void>> running;
  for (std::size_t w = 0; w < workers; ++w)
    running.push_back(std::async(std::launch::async, [&, w] {
      for (std::size_t i = w; i < models.size(); i += workers)
        trials[i] = tryWalk(plan, models[i], params, seed + i);
    }));
  for (auto& worker : running) worker.get();
  return trials;
}

double gainOf(const std::vector<WalkTrial>& trials, const WalkAim& aim) {
  double gain = 0.0;
  const double count = static_cast<double>(trials.size());
  for (std::size_t way = 0; way < kWalkWays; ++way) {
    double sum = 0.0;
    double least = trials[0].speed[way];
    for (const WalkTrial& trial : trials) {
      sum += trial.speed[way];
      least = std::min(least, trial.speed[way]);
    }
    const double judged = 0.5 * (sum / count + least);
    gain += aim.weight[way] * worth(judged / aim.speed[way]);
  }
  for (const WalkTrial& trial : trials)
    gain -= (trial.fell ? 1.0 : 0.0) + aim.swayCosts * trial.sway / count;
  return gain;
}

}  // namespace kelpie::learn
